package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.device.DeviceField;

final class CellWiringTest {
  private static final String DEVICES =
      """
      [
        {"type": "gripper", "close": "digital_out[0]", "gripped": "digital_in[1]"},
        {"type": "belt", "object": "conveyor", "speed": 0.1},
        {"type": "lamp", "name": "busy", "signal": "digital_out[1]"},
        {"type": "proximity", "signal": "digital_in[1]", "at": [0, 0, 0], "range": 0.1},
        {"type": "rg"}
      ]
      """;
  private static final String RULES =
      """
      [{"when": "digital_out[2] rises and digital_in[1] is on", "set": "digital_in[3]"}]
      """;
  private static final List<DeviceText> ALL = DeviceText.read(DEVICES);

  private static WirePort port(String device, String key) {
    return CellWiring.of(ALL, "").ports().stream()
        .filter(each -> each.device().equals(device) && each.key().equals(key))
        .findFirst()
        .orElseThrow();
  }

  private static WireSignal signal(String name) {
    return CellWiring.signals().stream()
        .flatMap(group -> group.signals().stream())
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static DeviceText named(List<DeviceText> devices, String name) {
    return devices.stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
  }

  @Test
  void portsAreThoseOfTheKindOfDevice() {
    List<CellWiring.Box> boxes = CellWiring.of(ALL, "").boxes();
    assertEquals(
        List.of("close", "open", "closed", "opened", "gripped"),
        boxes.getFirst().ports().stream().map(WirePort::key).toList());
    assertEquals(
        List.of("run", "encoder"), boxes.get(1).ports().stream().map(WirePort::key).toList());
    assertEquals("XML-RPC at http://localhost:41414", boxes.getLast().reached());
  }

  @Test
  void rulesAreABoxOfWhatTheyWatchAndSet() {
    CellWiring wiring = CellWiring.of(ALL, RULES);
    CellWiring.Box rules = wiring.boxes().getLast();
    assertEquals(
        List.of("digital_out[2]", "digital_in[1]", "digital_in[3]"),
        rules.ports().stream().map(WirePort::signal).toList());
    assertTrue(rules.ports().stream().allMatch(WirePort::fixed));
    assertEquals(
        "rules are changed as text, on the page Forms",
        rules.ports().getFirst().refusal(signal("digital_in[0]")));
  }

  @Test
  void anOutputOfADeviceGoesToNoOutput() {
    assertEquals(
        "Gripped of gripper is set by the device: it goes to an input, digital_out[3] is an output",
        port("gripper", "gripped").refusal(signal("digital_out[3]")));
    assertEquals("", port("gripper", "gripped").refusal(signal("configurable_in[7]")));
  }

  @Test
  void whatADeviceWatchesMayBeAnySignal() {
    WirePort lamp = port("busy", "signal");
    for (String each : List.of("digital_out[0]", "tool_in[1]", "flag[31]")) {
      assertEquals("", lamp.refusal(signal(each)), each);
    }
    assertEquals(
        "Signal of busy watches a level: it goes to a signal, encoder[0] is an encoder",
        lamp.refusal(signal("encoder[0]")));
  }

  @Test
  void wiresGoFromOneSideToTheOther() {
    WireRow gripped = new WireRow.OfPort(port("gripper", "gripped"));
    WireRow input = new WireRow.OfSignal(signal("digital_in[0]"), "");
    assertEquals("", WireRow.refusal(gripped, input));
    assertEquals("", WireRow.refusal(input, gripped));
    assertEquals(
        "a wire goes from a device to a signal of the controller",
        WireRow.refusal(gripped, gripped));
    assertEquals(
        "a wire goes from a signal of the controller to a device", WireRow.refusal(input, input));
  }

  @Test
  void aWireSetsTheFieldOfItsDevice() {
    List<DeviceText> next = CellWiring.wired(ALL, port("gripper", "closed"), "digital_in[5]");
    assertEquals("digital_in[5]", named(next, "gripper").text("closed"));
    assertEquals(ALL.subList(1, ALL.size()), next.subList(1, next.size()));
    next = CellWiring.wired(next, port("gripper", "closed"), "");
    assertEquals(ALL, next);
  }

  @Test
  void aBeltThatIsWiredToAnEncoderSaysHowManyTicksThatHas() {
    WirePort encoder = port("belt", "encoder");
    List<DeviceText> next = CellWiring.wired(ALL, encoder, "encoder[1]");
    assertEquals(OptionalDouble.of(1), named(next, "belt").number("encoder"));
    assertEquals(OptionalDouble.of(10_000), named(next, "belt").number("ticks"));
    assertEquals("encoder[1]", CellWiring.of(next, "").now(encoder).orElseThrow().signal());
    assertEquals(
        OptionalDouble.empty(),
        named(CellWiring.wired(next, encoder, ""), "belt").number("encoder"));
  }

  @Test
  void whatAlsoSetsAnInputIsTold() {
    CellWiring wiring = CellWiring.of(ALL, "");
    assertEquals(
        "digital_in[1] is also set by gripper",
        wiring.alsoSetBy(port("proximity", "signal"), "digital_in[1]"));
    assertEquals("", wiring.alsoSetBy(port("busy", "signal"), "digital_in[1]"));
  }

  @Test
  void aWireThatMustBeThereCannotBeRemoved() {
    assertEquals(
        "Close of gripper must have a wire: drag it to another signal instead",
        port("gripper", "close").removalRefusal());
    assertEquals("", port("gripper", "gripped").removalRefusal());
  }

  @Test
  void wiresMayLeadToSignalsOfOtherControllersAndOfDevices() {
    List<WireSignal> others =
        CellWiring.ofControllers(List.of("left", "cell")).stream()
            .flatMap(group -> group.signals().stream())
            .toList();
    DeviceField.Wire watched = new DeviceField.Wire("close", "Close", "closes it", false, true);
    DeviceField.Wire told = new DeviceField.Wire("closed", "Closed", "tells", true, true);
    List<String> watches = DeviceForm.withOthers(watched, others, "door");
    List<String> tells = DeviceForm.withOthers(told, others, "door");
    assertTrue(watches.contains("cell.digital_out[0]"), watches::toString);
    assertTrue(watches.contains("cell.digital_in[0]"), watches::toString);
    assertTrue(tells.contains("cell.digital_in[7]"), tells::toString);
    assertFalse(tells.contains("cell.digital_out[0]"), tells::toString);
    assertFalse(watches.contains("left.digital_out[0]"), "the first needs no name");
    assertFalse(DeviceForm.withOthers(watched, others, "cell").contains("cell.digital_out[0]"));
  }
}
