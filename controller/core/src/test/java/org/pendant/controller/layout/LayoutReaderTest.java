package org.pendant.controller.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.world.MeshFiles;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;

final class LayoutReaderTest {
  private static CellPlan plan(String text) throws JsonException {
    return CellPlan.read(
        "cell.json",
        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
        MeshFiles.NONE);
  }

  @Test
  void aSceneWithoutArmsHasOneController() throws JsonException {
    assertTrue(plan("{}").layout().alone());
    assertEquals(List.of(), plan("{}").layout().names());
  }

  @Test
  void armsComeBeforeTheScriptOfTheCell() throws JsonException {
    CellPlan plan =
        plan(
            """
            {
              "arms": [
                {"name": "left", "robot": "ur3e", "program": "left.script"},
                {"name": "right", "base": [1, 0, 0, 0, 0, 3], "address": "127.0.0.3"}
              ],
              "script": "cell/plc.script"
            }\
            """);
    assertEquals(List.of("left", "right", "cell"), plan.layout().names());
    assertEquals(new Pose(1, 0, 0, 0, 0, 3), plan.arms().get(1).baseInCell());
    assertEquals("cell/plc.script", plan.layout().script().orElseThrow().name());
  }

  @Test
  void aScriptAloneGoesWithOneArm() throws JsonException {
    assertEquals(List.of("arm", "cell"), plan("{\"script\": \"plc.script\"}").layout().names());
  }

  @Test
  void aDeviceBelongsToTheControllerOfItsSignals() throws JsonException {
    CellPlan plan =
        plan(
            """
            {
              "arms": [{"name": "left"}, {"name": "right"}],
              "devices": [
                {"type": "door", "close": "right.digital_out[0]", "closed": "right.digital_in[0]"},
                {"type": "lamp", "signal": "digital_out[1]"},
                {"type": "rg", "controller": "right"}
              ]
            }\
            """);
    assertEquals(1, plan.equipment().devices().get(0).devices().size());
    assertEquals(2, plan.equipment().devices().get(1).devices().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "{'arms': [{'name': 'a b'}]} | 1:20: name is \"a b\", must begin with a letter",
        "{'arms': [{'name': 'cell'}]} | 1:20: name is \"cell\", must begin with a letter",
        "{'arms': [{'name': 'a'}, {'name': 'a'}]} | 1:35: name is \"a\" as in line 1, must be"
            + " another",
        "{'arms': [{'name': 'a', 'robot': 'ur6'}]} | 1:34: robot is \"ur6\", must be one of",
        "{'arms': [{'name': 'a', 'base': [1, 2]}]} | 1:33: base is",
        "{'arms': [{'name': 'a', 'base': [11, 0, 0, 0, 0, 0]}]} | 1:34: base[0] is 11 m, must be",
        "{'arms': [{'name': 'a', 'program': '../b.script'}]} | 1:36: program is \"../b.script\","
            + " must be",
        "{'arms': [{'name': 'a', 'program': '/b.script'}]} | 1:36: program is \"/b.script\", must"
            + " be",
        "{'arms': [{'name': 'a', 'address': '10.0.0.1'}]} | 1:36: address is \"10.0.0.1\", must be",
        "{'arms': [{'name': 'a', 'speed': 1}]} | 1:25: unknown key \"speed\"",
        "{'arms': [{}, {}, {}, {}, {}, {}, {}, {}, {}]} | 1:10: arms is an array of 9, must be",
        "{'wires': [['digital_out[0]', 'b.digital_in[0]']]} | 1:31: wire is \"b.digital_in[0]\","
            + " must be an input",
        "{'wires': [['digital_out[0]', 'digital_out[1]']]} | 1:31: wire is \"digital_out[1]\", must"
            + " be an input",
        "{'wires': [['digital_out[0]']]} | 1:12: a wire is an array of 1, must be an array of two"
            + " signals",
        "{'wires': [['digital_out[0]', 'digital_in[0]'], ['digital_out[1]', 'digital_in[0]']]} |"
            + " 1:68: wire leads to \"digital_in[0]\" as in line 1",
        "{'arms': [{'name': 'a'}], 'devices': [{'type': 'rg', 'controller': 'b'}]} | 1:68:"
            + " controller is \"b\", must be one of a",
        "{'script': 'p.script', 'devices': [{'type': 'rg', 'controller': 'cell'}]} | 1:36: rg is"
            + " one of the cell's controller",
        "{'devices': [{'type': 'rg', 'controller': 'a'}]} | 1:29: unknown key \"controller\"",
      })
  void whatIsWrongIsToldAtItsPlace(String text, String message) {
    JsonException e = assertThrows(JsonException.class, () -> plan(text.replace('\'', '"')));
    assertTrue(e.getMessage().startsWith("cell.json:" + message), e.getMessage());
  }
}
