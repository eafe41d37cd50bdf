#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the stages of the driven pendulum's Runge-Kutta methods, src/driven/furiko_driven_stages.inc.

A method for y' = f(t, y) with weights a[i][j] (the last row: b) is written for x'' = f(t, x, x'), unit step:
stage i sees x + c[i] x' + sum over j of (a a)[i][j] k[j] and x' + sum of a[i][j] k[j], and k[i] is x'' there.
So the positions of the stages need not be kept.

The numbers of order 8 are Dormand and Prince's, as published with DOP853 (its 12 stages and the weights of
order 8): Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., 1993, II.5 and II.10.

usage: make_driven_stages.py [FOLDER]
"""
import pathlib
import sys

from mpmath import mp, mpf

mp.dps = 40
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "src" / "driven"
RK4 = {2: {1: "0.5"}, 3: {2: "0.5"}, 4: {3: "1"}, 5: {1: "1/6", 2: "1/3", 3: "1/3", 4: "1/6"}}
ORDER8 = {
    2: {1: "5.26001519587677318785587544488e-2"},
    3: {1: "1.97250569845378994544595329183e-2", 2: "5.91751709536136983633785987549e-2"},
    4: {1: "2.95875854768068491816892993775e-2", 3: "8.87627564304205475450678981324e-2"},
    5: {1: "2.41365134159266685502369798665e-1", 3: "-8.84549479328286085344864962717e-1",
        4: "9.24834003261792003115737966543e-1"},
    6: {1: "3.7037037037037037037037037037e-2", 4: "1.70828608729473871279604482173e-1",
        5: "1.25467687566822425016691814123e-1"},
    7: {1: "3.7109375e-2", 4: "1.70252211019544039314978060272e-1",
        5: "6.02165389804559606850219397283e-2", 6: "-1.7578125e-2"},
    8: {1: "3.70920001185047927108779319836e-2", 4: "1.70383925712239993810214054705e-1",
        5: "1.07262030446373284651809199168e-1", 6: "-1.53194377486244017527936158236e-2",
        7: "8.27378916381402288758473766002e-3"},
    9: {1: "6.24110958716075717114429577812e-1", 4: "-3.36089262944694129406857109825",
        5: "-8.68219346841726006818189891453e-1", 6: "2.75920996994467083049415600797e1",
        7: "2.01540675504778934086186788979e1", 8: "-4.34898841810699588477366255144e1"},
    10: {1: "4.77662536438264365890433908527e-1", 4: "-2.48811461997166764192642586468",
         5: "-5.90290826836842996371446475743e-1", 6: "2.12300514481811942347288949897e1",
         7: "1.52792336328824235832596922938e1", 8: "-3.32882109689848629194453265587e1",
         9: "-2.03312017085086261358222928593e-2"},
    11: {1: "-9.3714243008598732571704021658e-1", 4: "5.18637242884406370830023853209",
         5: "1.09143734899672957818500254654", 6: "-8.14978701074692612513997267357",
         7: "-1.85200656599969598641566180701e1", 8: "2.27394870993505042818970056734e1",
         9: "2.49360555267965238987089396762", 10: "-3.0467644718982195003823669022"},
    12: {1: "2.27331014751653820792359768449", 4: "-1.05344954667372501984066689879e1",
         5: "-2.00087205822486249909675718444", 6: "-1.79589318631187989172765950534e1",
         7: "2.79488845294199600508499808837e1", 8: "-2.85899827713502369474065508674",
         9: "-8.87285693353062954433549289258", 10: "1.23605671757943030647266201528e1",
         11: "6.43392746015763530355970484046e-1"},
    13: {1: "5.42937341165687622380535766363e-2", 6: "4.45031289275240888144113950566",
         7: "1.89151789931450038304281599044", 8: "-5.8012039600105847814672114227",
         9: "3.1116436695781989440891606237e-1", 10: "-1.52160949662516078556178806805e-1",
         11: "2.01365400804030348374776537501e-1", 12: "4.47106157277725905176885569043e-2"},
}
WIDTH = 96


def value(text):
    """A decimal or a quotient"""
    return mp.fdiv(*(mpf(part) for part in text.split("/"))) if "/" in text else mpf(text)


def literal(x):
    """A number with 21 digits"""
    return mp.nstr(x, 21, min_fixed=-3, max_fixed=3).replace("e+0", "") + "_wp"


def weighted(start, terms):
    """start + a k(:, 1) + ..., in lines that fit"""
    lines, line = [], start
    for j, a in terms:
        sign = "-" if a < 0 else "+"
        term = f" {sign} {literal(abs(a))}*k(:, {j})"
        if len(line) + len(term) > WIDTH:
            lines.append(line + " &")
            line = " "*11 + term
        else:
            line += term
    return [*lines, line]


def sums(method):
    """By stage: where it is, the terms of the position and those of the rate"""
    a = {i: {j: value(text) for j, text in row.items()} for i, row in method.items()}
    for i, row in a.items():
        squared = {}
        for m, weight in row.items():
            for j, more in a.get(m, {}).items():
                squared[j] = squared.get(j, mpf(0)) + weight*more
        # Weights of published numbers that cancel but for their last digits are none.
        yield i, sum(row.values()), [(j, squared[j]) for j in sorted(squared) if abs(squared[j]) > mpf(10)**-24], \
            sorted(row.items())


def statements(indent, names, c, squared, row):
    """What a stage sees"""
    drift = "x + v" if abs(c - 1) < mpf(10)**-24 else f"x + {literal(c)}*v"
    return weighted(f"{indent}{names[0]} = " + (f"({drift})" if squared else drift), squared) + \
        weighted(f"{indent}{names[1]} = v", row)


def procedures(name, method):
    """The text of a method"""
    *stages, last = sums(method)
    text = [f"   !> What stage i = 2 ... {last[0] - 1} sees",
            f"   pure subroutine reach_{name}(i, x, v, k, position, rate)",
            "      integer, intent(in) :: i",
            "      real(wp), intent(in) :: x(block)", "      real(wp), intent(in) :: v(block)",
            "      real(wp), intent(in) :: k(block, most_stages)",
            "      real(wp), intent(out) :: position(block)", "      real(wp), intent(out) :: rate(block)", "",
            "      select case (i)"]
    for i, *stage in stages:
        text += [f"      case ({i})" if i < last[0] - 1 else "      case default"]
        text += statements(" "*9, ("position", "rate"), *stage)
    return [*text, "      end select", f"   end subroutine reach_{name}", "", "",
            "   !> To the end of the step", f"   pure subroutine finish_{name}(k, x, v)",
            "      real(wp), intent(in) :: k(block, most_stages)",
            "      real(wp), intent(inout) :: x(block)", "      real(wp), intent(inout) :: v(block)", "",
            *statements(" "*6, ("x", "v"), *last[1:]), f"   end subroutine finish_{name}"]


def nodes(name, method):
    """Where in the step the stages are"""
    last = max(method)
    c = [sum(map(value, method[i].values())) if i in method else mpf(0) for i in range(1, last)]
    return [f"   !> Where in the step the stages of `reach_{name}` are",
            f"   real(wp), parameter :: {name}_nodes({last - 1}) = [ &",
            *(f"      {literal(x)}{', &' if i < len(c) - 1 else ']'}" for i, x in enumerate(c))]


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    head = ["   ! Written by make_driven_stages.py"]
    both = (("rk4", RK4), ("order8", ORDER8))
    text = head + [line for i, method in enumerate(both) for line in ([""]*(2*(i > 0)) + procedures(*method))]
    (folder/"furiko_driven_stages.inc").write_text("\n".join(text) + "\n")
    text = head + [line for method in both for line in nodes(*method)]
    (folder/"furiko_driven_nodes.inc").write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    main()
