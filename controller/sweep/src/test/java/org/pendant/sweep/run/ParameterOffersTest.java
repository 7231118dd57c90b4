package org.pendant.sweep.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.TargetText;

final class ParameterOffersTest {
  private static final String PROGRAM =
      """
      FAST = 0.8
      careful = True
      parts = 3
      pick = p[0.4, -0.1, 0.2, 0, 3.14, 0]
      home = [0, -1.57, 1.57, -1.57, -1.57, 0]
      place = get_actual_tcp_pose()
      def go(offset = -0.02):
        if get_standard_digital_in(3):
          movel(pose_add(pick, p[0, 0, offset, 0, 0, 0]), a=1.2, v=FAST)
        end
        movej(home, v=1.05)
      end
      go()
      """;

  @TempDir private Path folder;

  private Map<String, ParameterOffer> offers(String more) throws IOException, PlanException {
    Files.writeString(folder.resolve("a.script"), PROGRAM);
    // what the plan varies so far does not matter
    String plan =
        "program = \"a.script\"\n" + more + "[[parameter]]\nset = \"seed\"\nvalues = [1]\n";
    return ParameterOffers.of(PlanReader.read("p.toml", plan), folder).stream()
        .collect(
            Collectors.toMap(
                each -> TargetText.of(each.target()),
                each -> each,
                (one, _) -> one,
                LinkedHashMap::new));
  }

  private static List<String> words(ParameterOffer offer) {
    return List.of(offer.now(), offer.from(), offer.to(), offer.values());
  }

  @Test
  void variablesAreOfferedWithWhatTheyAreAndARangeAroundIt() throws IOException, PlanException {
    Map<String, ParameterOffer> offers = offers("");
    assertEquals(
        List.of("speed", "acceleration", "variable FAST", "variable careful"),
        List.copyOf(offers.keySet()).subList(0, 4),
        "as in the text, below what all moves have");
    assertEquals(List.of("0.8", "0.4", "1.2", ""), words(offers.get("variable FAST")));
    assertEquals(List.of("-0.02", "-0.03", "-0.01", ""), words(offers.get("variable offset")));
    assertEquals(List.of("3", "", "", "2, 3, 4"), words(offers.get("variable parts")));
    assertEquals(List.of("True", "", "", "True, False"), words(offers.get("variable careful")));
  }

  @Test
  void posesAreOfferedByTheirElements() throws IOException, PlanException {
    Map<String, ParameterOffer> offers = offers("");
    assertEquals(List.of("-0.1", "-0.15", "-0.05", ""), words(offers.get("variable pick[1]")));
    assertEquals("m", offers.get("variable pick[1]").unit());
    assertEquals("rad", offers.get("variable pick[4]").unit());
    assertEquals(List.of("-1.57", "-1.67", "-1.47", ""), words(offers.get("variable home[1]")));
    assertEquals("get_actual_tcp_pose()", offers.get("variable place").now());
  }

  @Test
  void numbersInMovesAndInputsThatTheProgramReadsAreOffered() throws IOException, PlanException {
    Map<String, ParameterOffer> offers = offers("");
    assertEquals(List.of("1.05", "0.525", "1.575", ""), words(offers.get("argument 11 v")));
    assertEquals("rad/s", offers.get("argument 11 v").unit());
    assertTrue(offers.keySet().containsAll(List.of("argument 9 a", "speed", "acceleration")));
    assertTrue(!offers.containsKey("argument 9 v"), "FAST is a variable");
    assertTrue(
        offers
            .keySet()
            .containsAll(List.of("input digital_in[3]", "input digital_in[3] time", "robot")));
  }

  @Test
  void objectsOfTheSceneAreOffered() throws IOException, PlanException {
    Files.writeString(
        folder.resolve("a.scene.json"),
        """
        {"objects": [{"type": "box", "name": "part 1", "pose": [0.5, 0, 0.1, 0, 0, 0], "size": [0.1, 0.1, 0.1]}]}
        """);
    Map<String, ParameterOffer> offers = offers("scene = \"a.scene.json\"\n");
    assertEquals(List.of("0", "-0.01", "0.01", ""), words(offers.get("object part 1 x")));
  }
}
