package org.pendant.controller.box;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.models.json.JsonException;

class EquipmentReaderTest {
  private static CellEquipment read(String text) throws JsonException {
    return EquipmentReader.read(
        "cell.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void devicesNeedOnlyTheirType() throws Exception {
    assertEquals(
        List.of(DeviceSetup.of("two-finger").orElseThrow()),
        read("{\"devices\": [{\"type\": \"two-finger\"}]}").devices());
  }

  @Test
  void everythingOfADeviceIsRead() throws Exception {
    assertEquals(
        List.of(new DeviceSetup.TwoFinger("left", false, false, 0.03)),
        read("{\"devices\": [{\"type\": \"two-finger\", \"name\": \"left\","
                + " \"activated\": false, \"part\": 0.03}]}")
            .devices());
  }

  @Test
  void theFileOfTheDocumentationIsRead() throws Exception {
    String page = Files.readString(Path.of("../../docs/devices.md"));
    int start = page.indexOf("```json\n") + "```json\n".length();
    CellEquipment cell = read(page.substring(start, page.indexOf("```", start)));
    assertEquals(3, cell.devices().size());
    assertEquals(4, cell.rules().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{'devices': [{'type': 'two-fingers'}]} | 1:23: type is \"two-fingers\", must be",
        "{'devices': [{'type': 'two-finger', 'pat': 1}]} | 1:37: unknown key \"pat\", did you mean"
            + " part?",
        "{'devices': [{'type': 'two-finger', 'part': 30}]} | 1:45: part is 30 m, must be 0 to"
            + " 0.085 m",
        "{'devices': [{'type': 'rg', 'fingers': {'friction': 3}}]} | 1:53: friction is 3, must be 0"
            + " to 2",
        "{'devices': [{'type': 'rg', 'fingers': {'at': [0, 9, 0, 0, 0, 0]}}]} | 1:51: at[1] is 9 m,"
            + " must be -4 to 4 m",
        "{'devices': [{'type': 'vacuum', 'suck': 'digital_out[0]', 'cup': {'force': 0}}]} | 1:76:"
            + " force is 0 N, must be 1 to 1000 N",
        "{'devices': [{'type': 'two-finger', 'activated': 1}]} | 1:50: activated is 1, must be"
            + " true or false",
        "{'devices': [{'type': 'two-finger'}, {'type': 'two-finger'}]} | 1:47: name is"
            + " \"two-finger\" as in line 1, must be another for each device",
        "{'devices': [{'type': 'gripper', 'close': 'digital_out[8]'}]} | 1:43: close is"
            + " \"digital_out[8]\", must be digital_out[0] to [7]",
        "{'devices': [{'type': 'modbus', 'address': '192.168.0.9', 'values': {'register[16]': 1}}]}"
            + " | 1:86: \"register[16]\": must be register[0] to [15]",
        "{'devices': [{'type': 'modbus', 'address': '192.168.0.9', 'values': {'coil[0]': 2}}]} |"
            + " 1:81: coil[0] is 2, must be 0 to 1",
        "{'devices': [{'type': 'modbus', 'address': '127.0.0.1'}]} | 1:44: address is"
            + " \"127.0.0.1\", which is the controller itself, must be another",
        "{'devices': [{'type': 'modbus', 'name': 'a', 'address': 'plc:502'}, {'type': 'modbus',"
            + " 'name': 'b', 'address': 'plc'}]} | 1:112: address is \"plc\", which a has, must be"
            + " another",
        "{'devices': [{'type': 'modbus', 'address': 'plc:0'}]} | 1:44: address is \"plc:0\", must"
            + " have a port of 1 to 65535",
        "{'devices': [{'type': 'modbus', 'address': 'plc', 'name': 'the plc'}]} | 1:59: name is"
            + " \"the plc\", must have letters",
        "{'devices': [{'type': 'modbus', 'address': 'plc', 'first': 65530}]} | 1:60: first is"
            + " 65530",
        "{'devices': [{'type': 'lamp', 'signal': 'plc.coil[16]'}, {'type': 'modbus', 'name': 'plc',"
            + " 'address': '192.168.0.9'}]} | 1:41: signal is \"plc.coil[16]\", must be"
            + " plc.coil[0] to [15]",
        "{'devices': [{'type': 'door', 'close': 'plc.register[0]'}, {'type': 'modbus', 'name':"
            + " 'plc', 'address': '192.168.0.9'}]} | 1:40: close is \"plc.register[0]\", must be a"
            + " digital signal, not a number",
        "{'devices': [{'type': 'gripper', 'close': 'plc.coil[0]'}]} | 1:43: close is"
            + " \"plc.coil[0]\", must be a signal, such as digital_out[0]",
        "{'devices': [{'type': 'proximity', 'signal': 'digital_out[0]', 'at': [0,0,0], 'range':"
            + " 1}]} | 1:46: signal is \"digital_out[0]\", must be an input",
        "{'devices': [{'type': 'camera', 'min': [0,0,0], 'max': [1,1,1], 'objects': ['lid']}]} |"
            + " 1:77: objects is \"lid\", must be the name of an object with a mass",
        "{'devices': [{'type': 'camera', 'min': [0,0,0], 'max': [1,1,1], 'port': 63352}]} | 1:73:"
            + " port is 63352, which the controller has, must be another",
        "{'devices': [{'type': 'camera', 'min': [0,0,0], 'max': [1,1,1], 'rpc': 50100}]} | 1:72:"
            + " rpc is 50100 as the other, must be another",
        "{'devices': [{'type': 'camera', 'min': [0,0,0], 'max': [1,1,1], 'noise': 1}]} | 1:74:"
            + " noise is 1 m, must be 0 to 0.1 m",
        "{'rules': [{'when': 'digital_out[2] jumps', 'set': 'digital_in[3]'}]} | 1:21: when: is"
            + " \"digital_out[2] jumps\", must be signals with rises, falls, is on or is off",
        "{'rules': [{'set': 'digital_in[3]'}]} | 1:12: a rule has 0 of when, while, every, must"
            + " have one",
        "{'rules': [{'every': 0, 'set': 'digital_in[3]'}]} | 1:22: every is 0 s, must be 0.01 to"
            + " 3600 s",
        "{'devices': [{'type': 'lamp', 'signal': 'digital_out[1]'}], 'rules': [{'every': 1,"
            + " 'press': 'lamp'}]} | 1:93: press is \"lamp\", must be the name of a limit switch or"
            + " a button",
        "{'rules': [{'every': 1, 'part': 'left', 'width': 0}]} | 1:33: part is \"left\", must be"
            + " the name of a gripper",
      })
  void whatIsWrongIsRefusedWithItsPlace(String text, String message) {
    JsonException refused = assertThrows(JsonException.class, () -> read(text.replace('\'', '"')));
    assertEquals(
        "cell.json:" + message,
        refused.getMessage().substring(0, ("cell.json:" + message).length()));
  }
}
