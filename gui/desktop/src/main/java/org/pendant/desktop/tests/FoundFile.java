package org.pendant.desktop.tests;

import java.util.List;
import org.pendant.testing.source.TestCase;

/**
 * Found file: a file of tests and what is in it.
 *
 * @param name below the folder of the tests
 * @param tests in the order in which they stand there
 * @param problems why none of them can run; empty where they can
 */
record FoundFile(String name, List<TestCase> tests, List<String> problems) {
  FoundFile {
    tests = List.copyOf(tests);
    problems = List.copyOf(problems);
  }
}
