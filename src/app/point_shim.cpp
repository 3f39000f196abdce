#include "app/commands.hpp"
namespace app {
void add_point_contact_command(CLI::App&, ExitCode&) {}
}  // namespace app
