package org.pendant.controller.quantity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;

final class StateQuantitiesTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  @Test
  void aComponentIsTheSameAloneAndWithTheOthers() {
    controller.advance();
    ControllerState state = controller.state();
    for (StateQuantity each : StateQuantities.all()) {
      double[] numbers = each.numbers(state);
      for (int i = 0; i < each.size(); i++) {
        String name = each.components().get(i).name();
        assertEquals(numbers[i], each.getter().element(i).applyAsDouble(state), name);
      }
    }
  }

  @Test
  void aQuantityWritesNoMoreThanItsComponents() {
    for (StateQuantity each : StateQuantities.all()) {
      double[] numbers = new double[each.size() + 2];
      numbers[0] = 7;
      numbers[each.size() + 1] = 7;
      each.getter().read(controller.state(), numbers, 1);
      assertEquals(List.of(7.0, 7.0), List.of(numbers[0], numbers[each.size() + 1]), each.name());
    }
  }

  @Test
  void noTwoComponentsHaveTheSameName() {
    Set<String> names = new HashSet<>();
    for (StateQuantity each : StateQuantities.all()) {
      for (Component component : each.components()) {
        assertEquals(true, names.add(component.name()), component.name());
      }
    }
  }

  @Test
  void aMisspeltNameIsRefused() {
    assertEquals(
        "there is no state quantity actual_Q",
        assertThrows(IllegalArgumentException.class, () -> StateQuantities.of("actual_Q"))
            .getMessage());
  }
}
