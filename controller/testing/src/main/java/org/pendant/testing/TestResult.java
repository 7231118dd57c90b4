package org.pendant.testing;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;

/**
 * Test result: one test and what came of it. Nothing in it depends on the computer or its clock,
 * except the time it took there.
 *
 * @param place where its definition begins
 * @param tags what it is marked with, sorted
 * @param skipped why it did not run; empty text where it did
 * @param failure why it is red; present exactly then
 * @param robotTimeS how much robot time it took
 * @param wallTimeS how long it took on this computer; no part of what must repeat
 * @param output lines that its programs wrote with {@code textmsg}, and what the controller said,
 *     oldest first; only the last ones of many
 */
public record TestResult(
    TestId id,
    TestPlace place,
    SortedSet<String> tags,
    TestStatus status,
    String skipped,
    Optional<TestFailure> failure,
    double robotTimeS,
    double wallTimeS,
    List<String> output) {
  public TestResult {
    output = List.copyOf(output);
  }
}
