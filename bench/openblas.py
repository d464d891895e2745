"""Settings with which OpenBLAS computes the same on all processors with AVX2: one thread, and the kernels for
Haswell, which are also those that it chooses under valgrind. Otherwise it chooses both by the processor. One
without AVX2 cannot run these kernels."""


def has_avx2():
    try:
        with open("/proc/cpuinfo") as file:
            return " avx2 " in file.read()
    except OSError:
        return False


SETTINGS = {"OPENBLAS_NUM_THREADS": "1"} | ({"OPENBLAS_CORETYPE": "Haswell"} if has_avx2() else {})
