package org.pendant.testing.coverage;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.script.coverage.CoverageMap;

/** What many runs have reached is put together by files and lines. */
class CoverageCollectorTest {
  private static final String TWO =
      """
      def two():
        a = 1
        if a == 2:
          a = 3
        end
      end
      """;

  private final CoverageCollector collector = new CoverageCollector();

  private FileCoverage file(String name) {
    return collector.report().files().stream()
        .filter(each -> each.file().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static List<String> told(FileCoverage file) {
    return file.lines().stream()
        .map(line -> line.line() + " " + line.statements().reached() + " " + line.tests())
        .toList();
  }

  @Test
  void eachLineTellsWhichTestsReachIt() {
    CoverageMap map = SampleCoverage.map("two.script", TWO);
    collector.add("b", SampleCoverage.run(map, "2", "3", "3F"), LineOrigin.file("two.script"));
    collector.add("a", SampleCoverage.run(map, "2"), LineOrigin.file("two.script"));
    assertEquals(List.of("2 1 [a, b]", "3 1 [b]", "4 0 []"), told(file("two.script")));
    assertEquals(List.of(new DecisionCoverage(3, "a == 2", 1, 0)), file("two.script").branches());
    assertEquals(
        List.of(new FunctionCoverage("two", 1, List.of("a", "b"))), file("two.script").functions());
  }

  @Test
  void aFileThatIsPartOfSeveralTextsCountsOnce() {
    CoverageMap alone = SampleCoverage.map("two.script", TWO);
    CoverageMap composed =
        SampleCoverage.map("test.script", "def helper():\n  return 1\nend\n" + TWO);
    collector.add("a", SampleCoverage.run(alone, "2"), LineOrigin.file("two.script"));
    collector.add(
        "b",
        SampleCoverage.run(composed, "5", "6", "6T", "7"),
        line ->
            line <= 3
                ? Optional.empty()
                : Optional.of(new LineOrigin.Place("two.script", line - 3)));
    assertEquals(1, collector.report().files().size());
    assertEquals(List.of("2 1 [a, b]", "3 1 [b]", "4 1 [b]"), told(file("two.script")));
    assertEquals(List.of(new DecisionCoverage(3, "a == 2", 0, 1)), file("two.script").branches());
    assertEquals(TWO.lines().toList(), file("two.script").text());
  }

  @Test
  void aProgramThatNoTestRunsIsReportedAsMissing() {
    collector.include(SampleCoverage.map("two.script", TWO), LineOrigin.file("two.script"));
    assertEquals("2-4", file("two.script").missing());
    assertEquals(List.of(), collector.report().tests());
  }

  @Test
  void severalRunsOfOneTestCountAsOneTest() {
    CoverageMap map = SampleCoverage.map("two.script", TWO);
    collector.add("a", SampleCoverage.run(map, "2", "3", "3F"), LineOrigin.file("two.script"));
    collector.add("a", SampleCoverage.run(map, "3T", "4"), LineOrigin.file("two.script"));
    assertEquals(List.of("2 1 [a]", "3 1 [a]", "4 1 [a]"), told(file("two.script")));
    assertEquals(List.of("a"), collector.report().tests());
  }

  @Test
  void statementsOnOneLineAreCountedEach() {
    CoverageMap map = SampleCoverage.map("x.script", "def x(): a = 1 b = 2 end");
    assertEquals(2, map.sites().stream().filter(each -> !each.kind().twoWay()).count() - 1);
    collector.add("a", SampleCoverage.run(map), LineOrigin.file("x.script"));
    assertEquals(new Share(0, 2), file("x.script").lines().getFirst().statements());
  }

  @Test
  void theOrderOfTestsDoesNotMatter() {
    CoverageMap map = SampleCoverage.map("two.script", TWO);
    CoverageCollector other = new CoverageCollector();
    for (int i = 0; i < 9; i++) {
      collector.add("t" + i, SampleCoverage.run(map, "2", "3", i + "F"), LineOrigin.file("f"));
      other.add(
          "t" + (8 - i), SampleCoverage.run(map, "2", "3", 8 - i + "F"), LineOrigin.file("f"));
    }
    assertEquals(collector.report(), other.report());
  }

  @Test
  void missingLinesAreRangesOverLinesWithStatements() {
    assertEquals("6-10", SampleCoverage.pick().files().getFirst().missing());
  }

  @Test
  void aShareIsOnlyWholeWhenNothingIsMissing() {
    assertEquals("99.9 %", new Share(9999, 10000).percent());
    assertEquals("100 %", new Share(3, 3).percent());
    assertEquals("66.6 %", new Share(2, 3).percent());
    assertEquals("-", Share.NONE.percent());
  }

  @Test
  void nodesOfATreeAreReachedWithTheirStatements() throws BrokenTree {
    TreeFile tree =
        TreeFile.read(
            "cell/count.pendant",
            """
            pendant program 1
            main
              assignment variable="a" expression="1"
              if condition="a == 2"
                assignment variable="b" expression="3"
              comment text="nothing to do"
            """
                .getBytes(StandardCharsets.UTF_8));
    GeneratedScript script = tree.script();
    CoverageMap map = SampleCoverage.map(tree.scriptName(), script.text());
    int third =
        script.places().stream().filter(p -> p.number() == 3).findFirst().orElseThrow().first();
    collector.add(
        "a", SampleCoverage.run(map, Integer.toString(third)), TreeOrigin.of(tree, script));
    TreeCoverage nodes = collector.report().trees().getFirst();
    assertEquals("cell/count.pendant", nodes.file());
    assertEquals(
        List.of("1 Robot Program: true", "2 a ≔ 1: false", "3 If a ≟ 2: true", "4 b ≔ 3: false"),
        nodes.nodes().stream()
            .map(node -> node.number() + " " + node.label() + ": " + node.reached())
            .toList());
    assertEquals(List.of("3 0 []", "4 1 [a]", "5 0 []"), told(file("cell/count.pendant")));
  }
}
