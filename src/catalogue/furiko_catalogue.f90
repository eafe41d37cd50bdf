! SPDX-License-Identifier: MIT

!> The library's functions by name: what `furiko eval --list` shows.
module furiko_catalogue
   implicit none
   private
   public :: catalogue, catalogue_entry, find_entry, argument_count, result_count


   !> A function of real arguments
   type :: catalogue_entry
      !> As in Fortran
      character(len=41) :: name
      !> Its arguments' symbols, in order
      character(len=12) :: arguments
      !> Its results' symbols
      character(len=8) :: results
      !> What it is
      character(len=52) :: about
   end type catalogue_entry


   !> Angles (phi, alpha, amplitude) are in radians; n is the characteristic of the third kind, in
   !> DLMF's sign.
   type(catalogue_entry), parameter :: catalogue(*) = [ &
      catalogue_entry('agm', 'a b', 'M', 'arithmetic-geometric mean'), &
      catalogue_entry('ellipk_k', 'k', 'K', 'complete, first kind'), &
      catalogue_entry('ellipk_m', 'm', 'K', 'complete, first kind'), &
      catalogue_entry('ellipk_mc', 'mc', 'K', 'complete, first kind'), &
      catalogue_entry('ellipk_alpha', 'alpha', 'K', 'complete, first kind'), &
      catalogue_entry('ellipe_k', 'k', 'E', 'complete, second kind'), &
      catalogue_entry('ellipe_m', 'm', 'E', 'complete, second kind'), &
      catalogue_entry('ellipe_mc', 'mc', 'E', 'complete, second kind'), &
      catalogue_entry('ellipe_alpha', 'alpha', 'E', 'complete, second kind'), &
      catalogue_entry('ellipke_k', 'k', 'K E', 'the two together'), &
      catalogue_entry('ellipke_m', 'm', 'K E', 'the two together'), &
      catalogue_entry('ellipke_mc', 'mc', 'K E', 'the two together'), &
      catalogue_entry('ellipke_alpha', 'alpha', 'K E', 'the two together'), &
      catalogue_entry('ellipb_k', 'k', 'B', 'complete, (E - mc K)/m'), &
      catalogue_entry('ellipb_m', 'm', 'B', 'complete, (E - mc K)/m'), &
      catalogue_entry('ellipb_mc', 'mc', 'B', 'complete, (E - mc K)/m'), &
      catalogue_entry('ellipb_alpha', 'alpha', 'B', 'complete, (E - mc K)/m'), &
      catalogue_entry('ellipd_k', 'k', 'D', 'complete, (K - E)/m'), &
      catalogue_entry('ellipd_m', 'm', 'D', 'complete, (K - E)/m'), &
      catalogue_entry('ellipd_mc', 'mc', 'D', 'complete, (K - E)/m'), &
      catalogue_entry('ellipd_alpha', 'alpha', 'D', 'complete, (K - E)/m'), &
      catalogue_entry('ellippi_k', 'n k', 'Pi', 'complete, third kind'), &
      catalogue_entry('ellippi_m', 'n m', 'Pi', 'complete, third kind'), &
      catalogue_entry('ellippi_mc', 'n mc', 'Pi', 'complete, third kind'), &
      catalogue_entry('ellipf_k', 'phi k', 'F', 'incomplete, first kind'), &
      catalogue_entry('ellipf_m', 'phi m', 'F', 'incomplete, first kind'), &
      catalogue_entry('ellipf_mc', 'phi mc', 'F', 'incomplete, first kind'), &
      catalogue_entry('ellipeinc_k', 'phi k', 'E', 'incomplete, second kind'), &
      catalogue_entry('ellipeinc_m', 'phi m', 'E', 'incomplete, second kind'), &
      catalogue_entry('ellipeinc_mc', 'phi mc', 'E', 'incomplete, second kind'), &
      catalogue_entry('ellipeinc_inverse_k', 's k', 'phi', 'inverse of ellipeinc'), &
      catalogue_entry('ellipeinc_inverse_m', 's m', 'phi', 'inverse of ellipeinc'), &
      catalogue_entry('ellipeinc_inverse_mc', 's mc', 'phi', 'inverse of ellipeinc'), &
      catalogue_entry('ellipdinc_k', 'phi k', 'D', 'incomplete, (F - E)/m'), &
      catalogue_entry('ellipdinc_m', 'phi m', 'D', 'incomplete, (F - E)/m'), &
      catalogue_entry('ellipdinc_mc', 'phi mc', 'D', 'incomplete, (F - E)/m'), &
      catalogue_entry('ellippiinc_k', 'n phi k', 'Pi', 'incomplete, third kind'), &
      catalogue_entry('ellippiinc_m', 'n phi m', 'Pi', 'incomplete, third kind'), &
      catalogue_entry('ellippiinc_mc', 'n phi mc', 'Pi', 'incomplete, third kind'), &
      catalogue_entry('carlson_rf', 'x y z', 'RF', 'Carlson''s first kind'), &
      catalogue_entry('carlson_rc', 'x y', 'RC', 'Carlson''s degenerate first kind'), &
      catalogue_entry('carlson_rd', 'x y z', 'RD', 'Carlson''s second kind, degenerate third'), &
      catalogue_entry('carlson_rj', 'x y z p', 'RJ', 'Carlson''s third kind'), &
      catalogue_entry('carlson_rg', 'x y z', 'RG', 'Carlson''s second kind, symmetric'), &
      catalogue_entry('jacobi_k', 'u k', 'sn cn dn', 'Jacobi elliptic functions'), &
      catalogue_entry('jacobi_m', 'u m', 'sn cn dn', 'Jacobi elliptic functions'), &
      catalogue_entry('jacobi_mc', 'u mc', 'sn cn dn', 'Jacobi elliptic functions'), &
      catalogue_entry('jacobi_sn_k', 'u k', 'sn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sn_m', 'u m', 'sn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sn_mc', 'u mc', 'sn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cn_k', 'u k', 'cn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cn_m', 'u m', 'cn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cn_mc', 'u mc', 'cn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dn_k', 'u k', 'dn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dn_m', 'u m', 'dn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dn_mc', 'u mc', 'dn', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ns_k', 'u k', 'ns', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ns_m', 'u m', 'ns', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ns_mc', 'u mc', 'ns', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nc_k', 'u k', 'nc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nc_m', 'u m', 'nc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nc_mc', 'u mc', 'nc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nd_k', 'u k', 'nd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nd_m', 'u m', 'nd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_nd_mc', 'u mc', 'nd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sc_k', 'u k', 'sc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sc_m', 'u m', 'sc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sc_mc', 'u mc', 'sc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cs_k', 'u k', 'cs', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cs_m', 'u m', 'cs', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cs_mc', 'u mc', 'cs', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sd_k', 'u k', 'sd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sd_m', 'u m', 'sd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_sd_mc', 'u mc', 'sd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ds_k', 'u k', 'ds', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ds_m', 'u m', 'ds', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_ds_mc', 'u mc', 'ds', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cd_k', 'u k', 'cd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cd_m', 'u m', 'cd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_cd_mc', 'u mc', 'cd', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dc_k', 'u k', 'dc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dc_m', 'u m', 'dc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_dc_mc', 'u mc', 'dc', 'Jacobi elliptic function'), &
      catalogue_entry('jacobi_am_k', 'u k', 'am', 'amplitude'), &
      catalogue_entry('jacobi_am_m', 'u m', 'am', 'amplitude'), &
      catalogue_entry('jacobi_am_mc', 'u mc', 'am', 'amplitude'), &
      catalogue_entry('jacobi_epsilon_k', 'u k', 'epsilon', 'integral of dn^2'), &
      catalogue_entry('jacobi_epsilon_m', 'u m', 'epsilon', 'integral of dn^2'), &
      catalogue_entry('jacobi_epsilon_mc', 'u mc', 'epsilon', 'integral of dn^2'), &
      catalogue_entry('jacobi_arcsn_k', 'x k', 'u', 'inverse of sn'), &
      catalogue_entry('jacobi_arcsn_m', 'x m', 'u', 'inverse of sn'), &
      catalogue_entry('jacobi_arcsn_mc', 'x mc', 'u', 'inverse of sn'), &
      catalogue_entry('jacobi_arccn_k', 'x k', 'u', 'inverse of cn'), &
      catalogue_entry('jacobi_arccn_m', 'x m', 'u', 'inverse of cn'), &
      catalogue_entry('jacobi_arccn_mc', 'x mc', 'u', 'inverse of cn'), &
      catalogue_entry('jacobi_arcdn_k', 'x k', 'u', 'inverse of dn'), &
      catalogue_entry('jacobi_arcdn_m', 'x m', 'u', 'inverse of dn'), &
      catalogue_entry('jacobi_arcdn_mc', 'x mc', 'u', 'inverse of dn'), &
      catalogue_entry('jacobi_arcns_k', 'x k', 'u', 'inverse of ns'), &
      catalogue_entry('jacobi_arcns_m', 'x m', 'u', 'inverse of ns'), &
      catalogue_entry('jacobi_arcns_mc', 'x mc', 'u', 'inverse of ns'), &
      catalogue_entry('jacobi_arcnc_k', 'x k', 'u', 'inverse of nc'), &
      catalogue_entry('jacobi_arcnc_m', 'x m', 'u', 'inverse of nc'), &
      catalogue_entry('jacobi_arcnc_mc', 'x mc', 'u', 'inverse of nc'), &
      catalogue_entry('jacobi_arcnd_k', 'x k', 'u', 'inverse of nd'), &
      catalogue_entry('jacobi_arcnd_m', 'x m', 'u', 'inverse of nd'), &
      catalogue_entry('jacobi_arcnd_mc', 'x mc', 'u', 'inverse of nd'), &
      catalogue_entry('jacobi_arcsc_k', 'x k', 'u', 'inverse of sc'), &
      catalogue_entry('jacobi_arcsc_m', 'x m', 'u', 'inverse of sc'), &
      catalogue_entry('jacobi_arcsc_mc', 'x mc', 'u', 'inverse of sc'), &
      catalogue_entry('jacobi_arccs_k', 'x k', 'u', 'inverse of cs'), &
      catalogue_entry('jacobi_arccs_m', 'x m', 'u', 'inverse of cs'), &
      catalogue_entry('jacobi_arccs_mc', 'x mc', 'u', 'inverse of cs'), &
      catalogue_entry('jacobi_arcsd_k', 'x k', 'u', 'inverse of sd'), &
      catalogue_entry('jacobi_arcsd_m', 'x m', 'u', 'inverse of sd'), &
      catalogue_entry('jacobi_arcsd_mc', 'x mc', 'u', 'inverse of sd'), &
      catalogue_entry('jacobi_arcds_k', 'x k', 'u', 'inverse of ds'), &
      catalogue_entry('jacobi_arcds_m', 'x m', 'u', 'inverse of ds'), &
      catalogue_entry('jacobi_arcds_mc', 'x mc', 'u', 'inverse of ds'), &
      catalogue_entry('jacobi_arccd_k', 'x k', 'u', 'inverse of cd'), &
      catalogue_entry('jacobi_arccd_m', 'x m', 'u', 'inverse of cd'), &
      catalogue_entry('jacobi_arccd_mc', 'x mc', 'u', 'inverse of cd'), &
      catalogue_entry('jacobi_arcdc_k', 'x k', 'u', 'inverse of dc'), &
      catalogue_entry('jacobi_arcdc_m', 'x m', 'u', 'inverse of dc'), &
      catalogue_entry('jacobi_arcdc_mc', 'x mc', 'u', 'inverse of dc'), &
      catalogue_entry('jacobi_zeta_k', 'phi k', 'Z', 'Jacobi zeta'), &
      catalogue_entry('jacobi_zeta_m', 'phi m', 'Z', 'Jacobi zeta'), &
      catalogue_entry('jacobi_zeta_mc', 'phi mc', 'Z', 'Jacobi zeta'), &
      catalogue_entry('heuman_lambda_k', 'phi k', 'Lambda', 'Heuman lambda'), &
      catalogue_entry('heuman_lambda_m', 'phi m', 'Lambda', 'Heuman lambda'), &
      catalogue_entry('heuman_lambda_mc', 'phi mc', 'Lambda', 'Heuman lambda'), &
      catalogue_entry('nome_k', 'k', 'q', 'nome, exp(-pi K/K)'), &
      catalogue_entry('nome_m', 'm', 'q', 'nome, exp(-pi K/K)'), &
      catalogue_entry('nome_mc', 'mc', 'q', 'nome, exp(-pi K/K)'), &
      catalogue_entry('parameter_from_nome', 'q', 'm', 'inverse of the nome'), &
      catalogue_entry('complementary_parameter_from_nome', 'q', 'mc', 'inverse of the nome, 1 - m'), &
      catalogue_entry('parameter_from_ellipk', 'kk', 'm', 'inverse of K'), &
      catalogue_entry('complementary_parameter_from_ellipk', 'kk', 'mc', 'inverse of K, 1 - m'), &
      catalogue_entry('parameter_from_period_ratio', 'ratio', 'm', 'inverse of T/T_h'), &
      catalogue_entry('complementary_parameter_from_period_ratio', 'ratio', 'mc', &
      'inverse of T/T_h, 1 - m'), &
      catalogue_entry('theta1', 'z q', 'theta1', 'theta function'), &
      catalogue_entry('theta2', 'z q', 'theta2', 'theta function'), &
      catalogue_entry('theta3', 'z q', 'theta3', 'theta function'), &
      catalogue_entry('theta4', 'z q', 'theta4', 'theta function'), &
      catalogue_entry('theta1_prime', 'z q', 'theta1''', 'its derivative by z'), &
      catalogue_entry('theta2_prime', 'z q', 'theta2''', 'its derivative by z'), &
      catalogue_entry('theta3_prime', 'z q', 'theta3''', 'its derivative by z'), &
      catalogue_entry('theta4_prime', 'z q', 'theta4''', 'its derivative by z'), &
      catalogue_entry('period_ratio', 'amplitude', 'T/T_h', &
      'period of a pendulum over that of its small swings'), &
      catalogue_entry('period_excess', 'amplitude', 'excess', 'T/T_h - 1'), &
      catalogue_entry('amplitude_of_period', 'ratio', 'theta_0', 'inverse of period_ratio'), &
      catalogue_entry('amplitude_of_excess', 'excess', 'theta_0', 'inverse of period_excess'), &
      catalogue_entry('amplitude_three_terms', 'excess', 'theta_0', 'the same by three terms of a series'), &
      catalogue_entry('ellipse_perimeter', 'a b', 'L', 'perimeter of an ellipse of these semiaxes')]


contains


   !> The entry of a name; with a blank name where there is none.
   elemental function find_entry(name) result(entry)
      character(len=*), intent(in) :: name
      type(catalogue_entry) :: entry
      integer :: i

      do i = 1, size(catalogue)
         entry = catalogue(i)
         if (entry%name == name) return
      end do
      entry%name = ''
   end function find_entry


   elemental function argument_count(entry)
      type(catalogue_entry), intent(in) :: entry
      integer :: argument_count

      argument_count = word_count(entry%arguments)
   end function argument_count


   elemental function result_count(entry)
      type(catalogue_entry), intent(in) :: entry
      integer :: result_count

      result_count = word_count(entry%results)
   end function result_count


   elemental function word_count(text)
      character(len=*), intent(in) :: text
      integer :: word_count
      integer :: i

      word_count = count([(text(i:i) /= ' ' .and. text(i + 1:i + 1) == ' ', i=1, len(text) - 1)])
      if (text(len(text):) /= ' ') word_count = word_count + 1
   end function word_count

end module furiko_catalogue
