package org.pendant.testing.mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

class TreeMutationsTest {
  private static Source source(String... main) {
    String text = "pendant program 1\nmain\n" + String.join("\n", main) + "\n";
    return Source.of("cell/boxes.pendant", text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** The line, what it becomes, and the line by which it is reached. */
  private static List<String> mutations(String... main) {
    Source source = source(main);
    return TreeMutations.in(source, Set.of(4, 5, 6)).stream()
        .map(
            each ->
                source.line(each.range().start())
                    + " "
                    + each.kind().text()
                    + ": "
                    + each.after(source)
                    + " @"
                    + each.reach())
        .toList();
  }

  @Test
  void speedsTimesAndBlendsAreTwiceAsLargeAndMovesLeftOut() {
    assertEquals(
        List.of(
            "3 move dropped:  @4",
            "3 speed: move kind=linear speed=0.2 acceleration=0.5 feature=\"Base\" @4",
            "3 speed: move kind=linear speed=0.1 acceleration=1 feature=\"Base\" @4",
            "4 speed: waypoint target=fixed name=\"Feeder\" blend-radius-m=0.06 @4"),
        mutations(
            "  move kind=linear speed=0.1 acceleration=0.5 feature=\"Base\"",
            "    waypoint target=fixed name=\"Feeder\" blend-radius-m=0.03"));
    assertEquals(
        List.of("3 call dropped:  @3", "3 speed: wait what=time time-s=0.6 @3"),
        mutations("  wait what=time time-s=0.3"));
  }

  @Test
  void ofSeveralWaypointsEachIsLeftOut() {
    assertEquals(
        List.of("4 move dropped:  @4", "5 move dropped:  @5"),
        mutations(
            "  move kind=joint",
            "    waypoint target=fixed name=\"A\"",
            "    waypoint target=fixed name=\"B\""));
  }

  @Test
  void outputsAreTheirNeighboursOrHaveTheOtherLevel() {
    assertEquals(
        List.of(
            "3 call dropped:  @3",
            "3 I/O swapped: set setting=digital signal=\"digital_out[1]\" level=true @3",
            "3 I/O swapped: set setting=digital signal=\"digital_out[0]\" level=false @3",
            "4 call dropped:  @4",
            "4 I/O swapped: set setting=digital signal=\"digital_out[2]\" @4",
            "4 I/O swapped: set setting=digital signal=\"digital_out[3]\" level=true @4"),
        mutations(
            "  set setting=digital signal=\"digital_out[0]\" level=true",
            "  set setting=digital signal=\"digital_out[3]\""));
  }

  @Test
  void conditionsAreTheOtherWayRoundAndCountsLarger() {
    assertEquals(
        List.of(
            "3 constant: loop rule=times count=\"7\" variable=\"turn\" @4",
            "4 condition: if condition=\"get_standard_digital_in(0)\" @4",
            "5 condition: elif condition=\"not (name == \\\"a\\\" or not done)\" @5",
            "6 call dropped:  @6",
            "6 constant: assignment variable=\"n\" expression=\"1\" @6"),
        mutations(
            "  loop rule=times count=\"6\" variable=\"turn\"",
            "    if condition=\"not get_standard_digital_in(0)\"",
            "    elif condition=\"name == \\\"a\\\" or not done\"",
            "      assignment variable=\"n\" expression=\"0\"",
            "      script-line code=\"textmsg(\\\"here\\\")\"",
            "      comment text=\"speed=3\""));
  }

  @Test
  void namedPositionsAndWhatIsWrittenInTextsStayAsTheyAre() {
    Source source =
        Source.of(
            "a.pendant",
            "pendant program 1\nposition name=\"speed=3\" tcp=[1, 2, 3, 0, 0, 0]\n"
                .getBytes(StandardCharsets.ISO_8859_1));
    assertEquals(List.of(), TreeMutations.in(source, Set.of()));
  }
}
