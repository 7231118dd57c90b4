package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableSample;

class VariableReaderTest {
  private final VariableReader reader = new VariableReader();

  private void take(List<byte[]> packages) {
    packages.forEach(each -> reader.take(ByteBuffer.wrap(each).position(5).slice()));
  }

  private void tell(List<VariableSample> variables) {
    take(VariablePackages.setup(1, variables));
    take(VariablePackages.update(1, variables));
    reader.pause();
  }

  private static VariableSample variable(String name, Value value) {
    return VariableSample.of(name, name, Optional.of(value), 0);
  }

  @Test
  void valuesOfEveryKindAreReadAsTheyWere() {
    List<Value> values =
        List.of(
            Value.of(true),
            Value.of(-5),
            Value.of(0.1),
            Value.of("grün"),
            NumberList.of(0.1, 2.5),
            NumberList.ofInts(1, 2, 3),
            NumberList.ofBools(true, false),
            NumberList.of(),
            new PoseValue(new Pose(0.1, -0.3, 0.5, 0, 3.14159, 0)));
    List<VariableSample> variables = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      variables.add(variable("v" + i, values.get(i)));
    }
    tell(variables);

    Map<String, Value> told = reader.told().values();
    for (int i = 0; i < values.size(); i++) {
      assertEquals(values.get(i), told.get("v" + i));
      assertEquals(values.get(i).kind(), told.get("v" + i).kind());
    }
  }

  @Test
  void manyVariablesComeInSeveralPackages() {
    tell(IntStream.range(0, 2_000).mapToObj(i -> variable("variable_" + i, Value.of(i))).toList());

    assertEquals(2_000, reader.told().values().size());
    assertEquals(Value.of(1_999), reader.told().values().get("variable_1999"));
    assertEquals(1, reader.told().whole());
  }

  @Test
  void whatIsToldIsWholeWhenTheControllerGoesOnToSomethingElse() {
    tell(List.of(variable("a", Value.of(1))));
    take(VariablePackages.update(2, List.of(variable("a", Value.of(2)))));

    assertEquals(new ProgramVariables(2, 1, Map.of("a", Value.of(1))), reader.told());
    reader.pause();
    assertEquals(new ProgramVariables(2, 2, Map.of("a", Value.of(2))), reader.told());
  }

  @Test
  void thatNothingHasChangedIsToldAsWell() {
    tell(List.of(variable("a", Value.of(1))));
    take(List.of(VariablePackages.empty()));
    reader.pause();

    assertEquals(new ProgramVariables(2, 2, Map.of("a", Value.of(1))), reader.told());
  }

  @Test
  void anotherProgramHasOtherVariables() {
    tell(List.of(variable("a", Value.of(1)), variable("b", Value.of(2))));
    tell(List.of(variable("b", Value.of(3))));

    assertEquals(Map.of("b", Value.of(3)), reader.told().values());
  }

  @Test
  void aVariableWithoutAValueIsNotThere() {
    tell(List.of(VariableSample.of("a", "a", Optional.empty(), 0), variable("b", Value.of(3))));

    assertEquals(Map.of("b", Value.of(3)), reader.told().values());
  }

  @Test
  void aValueOfAnUnknownTypeIsRefused() {
    byte[] bytes = HexFormat.of().parseHex("00000002DFDC18B001000063000000050A");

    assertThrows(IllegalArgumentException.class, () -> reader.take(ByteBuffer.wrap(bytes)));
  }
}
