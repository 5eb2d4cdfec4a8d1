#include "cli/commands.h"

int main(int argc, char** argv) { return lumaknot::run_program(argc, argv); }
