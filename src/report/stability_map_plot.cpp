#include "boxbeam/report/accuracy.hpp"
