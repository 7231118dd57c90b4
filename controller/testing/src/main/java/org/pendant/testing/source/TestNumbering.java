package org.pendant.testing.source;

import static org.pendant.testing.source.SourceTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.builtin.ExpectationBuiltins;

/** Numbering of the tests of a file: each gets a number, and the program lines that run it. */
final class TestNumbering {
  private Optional<TestScene> scene = Optional.empty();
  private final Source source;
  private final Composition composition;
  private final boolean before;
  private final boolean after;
  private final List<TestCase> tests = new ArrayList<>();

  /**
   * No tests yet.
   *
   * @param composition gets the lines
   * @param before whether the file has a function that runs before each test
   * @param after whether it has one that runs after each
   */
  TestNumbering(Source source, Composition composition, boolean before, boolean after) {
    this.source = source;
    this.composition = composition;
    this.before = before;
    this.after = after;
  }

  /**
   * Numbers the cases of a test.
   *
   * @param watches whether it starts programs
   * @return what is wrong with it
   */
  Optional<String> add(
      Definition test, TestMarks marks, Optional<TestScene> scene, boolean watches) {
    this.scene = scene;
    TestPlace place = composition.place(test.nameRange().start(), test.name());
    boolean needs = test.parameters().stream().anyMatch(TestNumbering::needed);
    if (marks.cases().isEmpty()) {
      if (needs) {
        return Optional.of(text("noCase", test.name()));
      }
      number(test, "", place, place, marks, watches);
    }
    for (TestMarks.Case each : marks.cases()) {
      TestPlace ofCase = composition.place(each.range().start(), test.name());
      number(test, each.arguments(), place, ofCase, marks, watches);
    }
    return Optional.empty();
  }

  private static boolean needed(ParameterDeclaration parameter) {
    return parameter.defaultValue().isEmpty();
  }

  private void number(
      Definition test,
      String arguments,
      TestPlace place,
      TestPlace called,
      TestMarks marks,
      boolean watches) {
    int number = tests.size();
    String row = arguments.isEmpty() ? "" : "[" + ByteText.decoded(arguments) + "]";
    tests.add(
        new TestCase(
            new TestId(source.name(), test.name(), row),
            number,
            place,
            marks.tags(),
            marks.skip(),
            marks.timeoutS(),
            marks.startRad(),
            scene,
            marks.property(),
            marks.golden(),
            watches));
    composition.add(
        (number == 0 ? "if " : "elif ") + ExpectationBuiltins.TEST_NUMBER + "() == " + number + ":",
        called);
    if (before) {
      composition.add("before_each()", called);
    }
    composition.add(test.name() + "(" + arguments + ")", called);
    if (after) {
      composition.add("after_each()", called);
    }
  }

  /** Ends the lines. */
  void end() {
    if (!tests.isEmpty()) {
      composition.add("end", tests.getLast().place());
    }
  }

  /** Those with a number. */
  List<TestCase> tests() {
    return tests;
  }
}
