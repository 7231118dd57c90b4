package org.pendant.testing.source;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.script.vm.Program;

/**
 * Test file: what a file of tests is once it has been read and compiled. Immutable; any number of
 * its tests may run at once.
 *
 * @param name as the command line gives it
 * @param program runs the test whose number the bench has
 * @param composition where each place of the program came from
 * @param tests in the order of the file
 * @param mocked the functions that its tests replace
 * @param functions the functions and builtins that it could replace by itself
 * @param starts the names of programs that each test may start, by its function
 * @param calls the functions that each test may call, by its function, what it imports included
 * @param sent its tests as programs for robots elsewhere
 * @param warnings what people should look at, with its place, a line each
 */
public record TestFile(
    String name,
    Program program,
    Composition composition,
    List<TestCase> tests,
    Set<String> mocked,
    Set<String> functions,
    Map<String, List<String>> starts,
    Map<String, List<String>> calls,
    SentTests sent,
    List<String> warnings) {
  public TestFile {
    tests = List.copyOf(tests);
    mocked = Set.copyOf(mocked);
    functions = Set.copyOf(functions);
    starts = Map.copyOf(starts);
    calls = Map.copyOf(calls);
    warnings = List.copyOf(warnings);
  }
}
