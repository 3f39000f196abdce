// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exit_codes.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "app/number_text.hpp"
#include "block/factorization_error.hpp"
#include "contact/contact_error.hpp"
#include "literate/error.hpp"
#include "numerics/quadrature.hpp"
#include "numerics/require.hpp"
#include "parameters/case_table.hpp"

namespace app {
namespace {

ExitCode answer(const std::exception& e, ExitCode code) {
  fmt::print(stderr, "halfspace: {}\n", e.what());
  return code;
}

ExitCode answer_failed_computation(const std::exception& e) {
  fmt::print(stderr, "halfspace: the computation failed: {}\n", e.what());
  return ExitCode::claim_failed;
}

}  // namespace

ExitCode run_guarded(const std::function<ExitCode()>& command) {
  try {
    return command();
  } catch (const numerics::InvalidQuantity& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const parameters::CaseError& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const parameters::UnitError& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const InputError& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const literate::OutputError& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const literate::SourceError& e) {
    return answer(e, ExitCode::bad_input);
  } catch (const literate::ToolError& e) {
    return answer(e, ExitCode::tool_failed);
  } catch (const numerics::QuadratureError& e) {
    return answer_failed_computation(e);
  } catch (const contact::ContactError& e) {
    return answer_failed_computation(e);
  } catch (const block::FactorizationError& e) {
    return answer_failed_computation(e);
  } catch (const std::exception& e) {
    return answer(e, ExitCode::claim_failed);
  }
}

ExitCode answer_faults(const std::vector<std::string>& faults) {
  for (const std::string& fault : faults) fmt::print(stderr, "halfspace: {}\n", fault);
  return faults.empty() ? ExitCode::success : ExitCode::claim_failed;
}

}  // namespace app
