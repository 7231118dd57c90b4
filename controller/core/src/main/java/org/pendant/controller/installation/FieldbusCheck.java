package org.pendant.controller.installation;

import static org.pendant.controller.installation.SetupTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusKind;

/** Fieldbus check: whether conveyors and Modbus signals can be as an installation says. */
final class FieldbusCheck {
  private static final int MAX_CONVEYORS = 2;
  private static final int LAST_DECODER = 4;
  private static final int QUADRATURE = 1;

  /** Numbers of inputs that a decoder can look at (manual 15.3). */
  private static final Set<Integer> PULSE_INPUTS = Set.of(8, 9, 10, 11);

  private static final int MAX_SIGNALS = 1000;
  private static final int LAST_UNIT = 255;
  private static final int LAST_ADDRESS = 65_535;
  private static final int MAX_HZ = 500;

  private final ProblemList problems;
  private final Installation installation;

  FieldbusCheck(ProblemList problems, Installation installation) {
    this.problems = problems;
    this.installation = installation;
  }

  void check() {
    List<ConveyorSetup> conveyors = installation.conveyors();
    problems.require(
        conveyors.size() <= MAX_CONVEYORS,
        "conveyors",
        () -> text("tooMany", conveyors.size(), MAX_CONVEYORS));
    Set<Integer> numbers = new HashSet<>();
    for (int i = 0; i < conveyors.size(); i++) {
      ConveyorSetup each = conveyors.get(i);
      String field = "conveyors[" + i + "].";
      problems.require(
          (each.number() == 1 || each.number() == 2) && numbers.add(each.number()),
          field + "number",
          () -> text("conveyorNumber", each.number()));
      conveyor(field, each);
    }
    problems.require(
        installation.modbus().size() <= MAX_SIGNALS,
        "modbus",
        () -> text("tooManySignals", MAX_SIGNALS));
    Set<String> names = new HashSet<>();
    for (int i = 0; i < installation.modbus().size(); i++) {
      modbus("modbus[" + i + "].", installation.modbus().get(i), names);
    }
  }

  private void conveyor(String field, ConveyorSetup conveyor) {
    problems.require(
        conveyor.encoder() == 0 || conveyor.encoder() == 1,
        field + "encoder",
        () -> text("zeroOrOne", conveyor.encoder()));
    problems.require(
        installation.feature(conveyor.feature()).isPresent(),
        field + "feature",
        () -> text("unknownFeature", conveyor.feature()));
    double ticks = conveyor.ticksPerUnit();
    problems.require(
        Double.isFinite(ticks) && ticks != 0,
        field + "ticksPerUnit",
        () -> text("ticksRange", ticks));
    int type = conveyor.decoder();
    if (type < 0 || type > LAST_DECODER) {
      problems.add(field + "decoder", text("numberRange", type, LAST_DECODER));
      return;
    }
    List<Integer> inputs = conveyor.inputs();
    int wanted = type == 0 ? 0 : type == QUADRATURE ? 2 : 1;
    problems.require(
        inputs.size() == wanted
            && PULSE_INPUTS.containsAll(inputs)
            && Set.copyOf(inputs).size() == wanted,
        field + "inputs",
        () -> text("pulseInputs", inputs, wanted));
  }

  private void modbus(String field, ModbusSetup signal, Set<String> names) {
    problems.require(
        !signal.name().isBlank() && signal.name().chars().noneMatch(Character::isISOControl),
        field + "name",
        () -> text("noNameOnOneLine"));
    problems.require(
        names.add(signal.name()), field + "name", () -> text("nameTaken", signal.name()));
    try {
      var _ = ModbusAddress.parse(signal.device());
    } catch (IllegalArgumentException e) {
      problems.add(field + "device", text("deviceRefused", signal.device(), e.getMessage()));
    }
    within(field + "unit", signal.unit(), LAST_UNIT);
    within(field + "address", signal.address(), LAST_ADDRESS);
    within(field + "updateHz", signal.updateHz(), MAX_HZ);
    problems.require(
        signal.kind() != ModbusKind.READ_WRITE_REGISTERS,
        field + "kind",
        () -> text("readWriteRegisters"));
  }

  private void within(String field, int value, int most) {
    problems.require(value >= 0 && value <= most, field, () -> text("numberRange", value, most));
  }
}
