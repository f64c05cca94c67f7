// check_arm and replay_log for the page's second worker, which writes the files that were dropped onto the page to the
// module's file system, in memory, and calls them as a shell would.
#include <emscripten.h>

int check_arm(int argc, char** argv);
int replay_log(int argc, char** argv);

int main(int argc, char** argv) {
  return argv[1][0] == 'c' ? check_arm(argc - 1, argv + 1) : replay_log(argc - 1, argv + 1);
}
