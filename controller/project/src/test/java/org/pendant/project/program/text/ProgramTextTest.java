package org.pendant.project.program.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

@Tag("slow")
class ProgramTextTest {
  private static final String PICK =
      """
      pendant program 1
      installation file="cell.pinst"
      position name="Above" tcp=[0.1, -0.3, 0.2, 0, 3.14, 0] feature="Base" joints-rad=[0, -1.5, -1.5, -1.5, 1.5, 0] tool-in-flange=[0, 0, 0.15, 0, 0, 0]
      initial-values
        - initial variable="parts" expression="0"
      main forever=true
        move kind=linear speed=0.25 acceleration=1.2 feature="Base"
          waypoint target=fixed name="Above" blend-radius-m=0.02
          suppressed waypoint target=variable expression="spot" timing=duration time-s=2
        wait what=time time-s=0.5
        script-file file="grip.script"
          | grip = 1

          |   if grip:
        comment text="say \\"now\\""
      """;

  private static ProgramTree pick() {
    return new ProgramTree(
            "cell.pinst",
            Map.of(
                "Above",
                new WaypointPosition(
                    new Pose(0.1, -0.3, 0.2, 0, 3.14, 0),
                    "Base",
                    new Joints(0, -1.5, -1.5, -1.5, 1.5, 0),
                    new Pose(0, 0, 0.15, 0, 0, 0))),
            List.of(),
            1)
        .insert(
            ProgramTree.ROOT,
            0,
            List.of(
                ProgramTree.node(
                    new Section.InitialValues(List.of(new Section.InitialValue("parts", "0")))),
                ProgramTree.node(
                    new Section.MainProgram(true),
                    ProgramTree.node(
                        new MotionStep.Move(
                            MoveKind.LINEAR, 0.25, 1.2, new ToolChoice.Active(), "Base", false),
                        ProgramTree.node(
                            new MotionStep.Waypoint(
                                new WaypointTarget.Fixed("Above"),
                                new Timing.AsMove(),
                                OptionalDouble.of(0.02))),
                        ProgramTree.node(
                                new MotionStep.Waypoint(
                                    new WaypointTarget.Variable("spot"),
                                    new Timing.Duration(2),
                                    OptionalDouble.empty()))
                            .withSuppressed(true)),
                    ProgramTree.node(new ActionStep.Wait(new WaitFor.Time(0.5))),
                    ProgramTree.node(
                        new ActionStep.ScriptFile(
                            "grip.script", List.of("grip = 1", "  if grip:"))),
                    ProgramTree.node(new ActionStep.Comment("say \"now\"")))));
  }

  /** What files in the world look like: a change here would make them unreadable. */
  @Test
  void readsTheFormatAsItHasAlwaysBeen() {
    ReadProgram read = ProgramText.read(PICK);
    assertEquals(List.of(), read.problems());
    assertEquals(pick(), read.tree());
  }

  @Test
  void writesOneNodeALine() {
    assertEquals(PICK.replace("\n\n", "\n"), ProgramText.write(pick()));
  }

  @Test
  void readsBackWhateverItWrites() {
    for (int seed = 0; seed < 400; seed++) {
      ProgramTree tree = new RandomTrees(seed).tree();
      String text = ProgramText.write(tree);
      ReadProgram read = ProgramText.read(text);
      assertEquals(List.of(), read.problems(), text);
      assertEquals(tree, read.tree(), text);
      assertEquals(text, ProgramText.write(read.tree()));
    }
  }

  static List<Class<? extends Record>> everyKind() {
    return Forms.leaves(Step.class).toList();
  }

  @ParameterizedTest
  @MethodSource("everyKind")
  void readsBackEveryKindOfNode(Class<? extends Record> kind) {
    for (int seed = 0; seed < 20; seed++) {
      List<ProgramNode> nodes = List.of(ProgramTree.node(new RandomTrees(seed).make(kind)));
      Clip clip = ProgramText.readClip(ProgramText.writeClip(nodes, Map.of())).orElseThrow();
      assertEquals(nodes.getFirst().step(), clip.nodes().getFirst().step());
    }
  }

  /** Fields of variants stand in the same line as those of the node. */
  @ParameterizedTest
  @MethodSource("everyKind")
  void noFieldOfANodeHasTheNameOfAnother(Class<? extends Record> kind) {
    keys(kind, new ArrayList<>());
  }

  private static void keys(Class<? extends Record> type, List<String> taken) {
    RecordComponent[] components = type.getRecordComponents();
    for (RecordComponent each : components) {
      assertTrue(!taken.contains(each.getName()), type + " has " + each.getName() + " twice");
      taken.add(each.getName());
    }
    for (RecordComponent each : components) {
      if (each.getType().isSealed()) {
        Forms.leaves(each.getType()).forEach(variant -> keys(variant, new ArrayList<>(taken)));
        Forms.leaves(each.getType())
            .flatMap(variant -> Arrays.stream(variant.getRecordComponents()))
            .forEach(inner -> taken.add(inner.getName()));
      }
    }
  }

  @Test
  void carriesNodesFromOneProgramToAnother() {
    ProgramNode main = pick().sections().get(1);
    String text = ProgramText.writeClip(main.children(), pick().waypoints());
    Clip clip = ProgramText.readClip(text).orElseThrow();
    assertEquals(pick().waypoints(), clip.waypoints());
    assertEquals(text, ProgramText.writeClip(clip.nodes(), clip.waypoints()));
  }

  @Test
  void doesNotTakeAnyTextForNodes() {
    assertTrue(ProgramText.readClip("movej([0,0,0,0,0,0])").isEmpty());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '!',
      quoteCharacter = '`',
      value = {
        "`  wait what=time time-s=soon`!25!time-s is soon, must be a number",
        "`  wait what=time`!3!wait must have a field time-s",
        "`  wait what=sleep`!13!what is sleep, must be one of nothing, time, digital, analog,"
            + " expression",
        "`  wait what=time time-s=1 speed=3`!27!wait has no field speed, it has what, time-s",
        "`  wiat what=time`!3!found wiat, must be one of",
        "`  comment text=\"unfinished`!16!the closing quote is missing",
        "`  comment text=bare`!16!text is bare, must be a text in quotes",
        "`    halt`!1!the line begins 4 blanks from the left, must begin at most 2",
        "`   halt`!1!the line begins with an odd number of blanks",
        "`  # remark`!3!a remark cannot be kept",
        "`halt`!1!halt stands at the left edge",
        "`  halt now`!11!= must follow now",
        "`  halt halt=1 halt=2`!15!halt stands in the line twice",
        "`  force kind=simple compliant=[true`!36!the list must continue with , or end with ]",
        "`  | text`!3!main has no lines that begin with |",
      })
  void saysWhatIsWrongAndWhere(String line, int column, String message) {
    ReadProgram read = ProgramText.read("pendant program 1\nmain\n" + line + "\n");
    assertEquals(1, read.problems().size(), read.problems().toString());
    TextProblem problem = read.problems().getFirst();
    assertEquals(3, problem.line());
    assertTrue(problem.message().startsWith(message), problem.message());
    assertEquals(column, problem.column(), problem.message());
  }

  @Test
  void keepsWhatItUnderstandsOfATextWithMistakes() {
    ReadProgram read =
        ProgramText.read("pendant program 1\nmain\n  halt\n  hlat\n  comment text=\"x\"\n");
    assertEquals(1, read.problems().size());
    assertEquals(3, read.tree().nodes().size());
  }

  @Test
  void refusesAnotherFormat() {
    ReadProgram read = ProgramText.read("def program():\n  halt\nend\n");
    assertEquals("the first line must be: pendant program 1", read.problems().getFirst().message());
  }

  @Test
  void survivesAnyTextAndAnyDepth() {
    StringBuilder deep = new StringBuilder("pendant program 1\nmain\n");
    for (int i = 1; i < 5000; i++) {
      deep.append("  ".repeat(i)).append("folder name=\"f\"\n");
    }
    assertTrue(
        ProgramText.read(deep.toString()).problems().toString().contains("more than 200 levels"));
    String text = ProgramText.write(pick());
    for (int i = 0; i < text.length(); i++) {
      ProgramText.read(text.substring(0, i));
      ProgramText.read(text.substring(0, i) + "\u0000[=\"" + text.substring(i));
    }
  }
}
