# SPDX-License-Identifier: GPL-3.0-or-later
# Plays the script STORY with the program PANEL as at a first start; pictures, settings and report
# go to OUT.
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
execute_process(
    COMMAND ${PANEL} --offscreen --simulate --language en --theme light --settings ${OUT}/settings.ini
            --script ${STORY} --screenshots ${OUT} --report ${OUT}/report.json
    WORKING_DIRECTORY ${OUT} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "The story ended with ${result}; what it did stands in ${OUT}/report.json")
endif()
file(READ ${OUT}/report.json report)
string(JSON passed GET ${report} passed)
if(NOT passed)
    message(FATAL_ERROR "Exit code 0, but the report does not say \"passed\": ${OUT}/report.json")
endif()
