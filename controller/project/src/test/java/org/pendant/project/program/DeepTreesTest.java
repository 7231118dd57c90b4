package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.project.program.script.ScriptGenerator;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;

/** Trees that are as deep as they may be, and deeper. */
final class DeepTreesTest {
  private static final String REFUSAL = "Nodes may not go more than 200 levels deep";

  /** {@code levels} nodes, each below the one before. */
  private static ProgramNode chain(int levels, Function<ProgramNode, ProgramNode> around) {
    ProgramNode inner = node(new ActionStep.Assignment("x", "1"));
    for (int i = 1; i < levels; i++) {
      inner = around.apply(inner);
    }
    return inner;
  }

  private static ProgramNode folders(int levels) {
    return chain(levels, inner -> node(new ActionStep.Folder("f"), inner));
  }

  private static ProgramTree program(ProgramNode node) {
    ProgramTree tree = ProgramTree.empty();
    return tree.insert(tree.sections().getFirst().key(), 0, List.of(node));
  }

  @Test
  void twoHundredLevelsAreWrittenReadAndGenerated() {
    ProgramTree tree = program(folders(200));
    assertEquals(201, tree.nodes().size());
    assertTrue(tree.find(201).isPresent());
    ReadProgram read = ProgramText.read(ProgramText.write(tree));
    assertEquals(List.of(), read.problems());
    assertEquals(tree, read.tree());
    assertEquals(List.of(), ProgramCheck.problems(tree, Installation.NONE));
    long innermost = 201;
    assertTrue(PlayFrom.from(tree, innermost).nodes().size() > 201);
    assertTrue(
        ScriptGenerator.generateFrom("deep", tree, innermost, Installation.NONE)
            .text()
            .contains("x = 1"));
  }

  @Test
  void moreLevelsAreRefused() {
    ProgramTree tree = ProgramTree.empty();
    for (int levels : new int[] {201, 5_000, 100_000}) {
      List<ProgramNode> added = List.of(folders(levels));
      assertEquals(Optional.of(REFUSAL), tree.whyTooDeep(1, added));
      assertEquals(
          REFUSAL,
          assertThrows(IllegalArgumentException.class, () -> tree.insert(1, 0, added))
              .getMessage());
    }
    List<ProgramNode> sections = List.of(node(new Section.MainProgram(true), folders(5_000)));
    assertThrows(
        IllegalArgumentException.class, () -> new ProgramTree("", Map.of(), sections, 10_000));
  }

  @Test
  void levelsCountFromTheSectionAndNotFromTheNode() {
    ProgramTree tree = program(folders(200));
    long innermost = 201;
    List<ProgramNode> one = List.of(node(new ActionStep.Halt()));
    assertEquals(Optional.of(REFUSAL), tree.whyTooDeep(innermost, one));
    assertEquals(Optional.empty(), tree.whyTooDeep(innermost - 1, one));
    assertEquals(Optional.empty(), tree.whyTooDeep(1, List.of(folders(200))));
    assertEquals(Optional.of(REFUSAL), tree.whyTooDeep(2, List.of(folders(200))));
    List<ProgramNode> wide =
        List.of(node(new ActionStep.Folder("a"), folders(2)), node(new ActionStep.Halt()));
    assertEquals(Optional.of(REFUSAL), tree.whyTooDeep(innermost - 2, wide));
    assertEquals(Optional.empty(), tree.whyTooDeep(innermost - 3, wide));
  }

  static Stream<Step> blocks() {
    return Stream.of(
        new FlowStep.If("True", false),
        new FlowStep.If("True", true),
        new FlowStep.Loop(new LoopRule.Forever()),
        new FlowStep.Loop(new LoopRule.Times("2", "")),
        new FlowStep.Loop(new LoopRule.While("True", true)));
  }

  /** A hundred blocks are open at once at most; a node may open several. */
  @ParameterizedTest
  @MethodSource("blocks")
  void moreBlocksThanTheLanguageHasAreAProblemOfTheNodeThatOpensThem(Step step) {
    ProgramTree tree = program(chain(200, inner -> node(step, inner)));
    List<NodeProblem> problems = ProgramCheck.problems(tree, Installation.NONE);
    assertEquals(1, problems.size(), problems::toString);
    NodeProblem problem = problems.getFirst();
    assertTrue(problem.blocks());
    assertEquals("nested too deeply: more than 100 blocks inside each other", problem.message());
    int number = (int) problem.key();
    List<ProgramNode> above = chain(number, tree);
    assertTrue(above.size() <= 100, () -> "node " + number);
    ProgramTree less = program(chain(above.size() - 5, inner -> node(step, inner)));
    assertEquals(List.of(), ProgramCheck.problems(less, Installation.NONE));
  }

  private static List<ProgramNode> chain(long key, ProgramTree tree) {
    return Stream.iterate(
            tree.find(key),
            Optional::isPresent,
            at -> tree.parentOf(at.get().key()).flatMap(tree::find))
        .map(Optional::get)
        .toList();
  }
}
