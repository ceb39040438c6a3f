# What a library must not do to the program it lives in: end it, print into its streams, jump over its frames, share its
# hidden state, start programs, or read its environment where a privileged program must not.
# What compilers bring along is theirs: __stack_chk_fail, std::terminate behind noexcept, and the C++ runtime that is linked.
cmake_minimum_required(VERSION 3.25)
set(banned
  abort exit _exit _Exit quick_exit atexit __cxa_atexit __cxa_thread_atexit on_exit __assert_fail raise kill # ends the program, or runs when it ends
  printf fprintf vprintf vfprintf puts fputs putchar putc fputc fwrite perror stdout stderr stdin
  __printf_chk __fprintf_chk __vfprintf_chk write _ZSt4cout _ZSt4cerr _ZSt4clog _ZNSt8ios_base4InitC1Ev # speaks
  sprintf vsprintf gets strcpy strcat __strcpy_chk __strcat_chk __sprintf_chk          # writes without bounds
  rand srand random srandom drand48 lrand48 rand_r strtok localtime gmtime asctime ctime strerror # hidden state
  setlocale strtod strtof atof                                                         # depends on the locale
  setjmp _setjmp __sigsetjmp longjmp _longjmp siglongjmp signal sigaction              # jumps, signals
  system popen fork vfork execve execv execvp posix_spawn dlclose                      # starts programs; unloads
  getenv                                                                               # secure_getenv is the one in use
  fopen open creat mkstemp tmpfile remove unlink rename                                # touches files
  sleep usleep alarm)
foreach(binary ${BINARIES})
  set(dynamic "")
  if(NOT binary MATCHES "\\.a$")
    set(dynamic -D)
  endif()
  execute_process(COMMAND ${NM} ${dynamic} --undefined-only --format=posix ${binary} OUTPUT_VARIABLE listing
    ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "${NM} ${binary}: ${errors}")
  endif()
  string(REGEX MATCHALL "(^|\n)[^ \n]+ [UwWvV]" lines "${listing}")
  set(undefined "")
  foreach(line ${lines})
    string(REGEX REPLACE "^\n?([^ @]+).*" "\\1" name "${line}")
    list(APPEND undefined ${name})
  endforeach()
  list(LENGTH undefined count)
  if(count LESS 5)
    message(SEND_ERROR "${binary}: only ${count} undefined symbols were found")
  endif()
  foreach(name ${banned})
    if(name IN_LIST undefined)
      message(SEND_ERROR "${binary} uses ${name}")
    endif()
  endforeach()
endforeach()
