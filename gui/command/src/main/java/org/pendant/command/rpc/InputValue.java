package org.pendant.command.rpc;

import java.util.Optional;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.json.Json;
import org.pendant.models.json.Range;

/** Input value: what an input is to have, as the text that {@code --input} takes. */
final class InputValue {
  private InputValue() {}

  /**
   * The text of a value.
   *
   * @param name of the input; a bare number at an analog one is in the unit of its domain
   * @param now the snapshot that tells the domain; empty where all are voltages
   */
  static String text(String name, Json value, Optional<ControllerState> now) throws RpcFailure {
    return switch (value) {
      case Json.Text text -> text.value();
      case Json.Numeral number -> Range.number(number.value()) + unit(name, now);
      case Json.Word word when !word.word().equals("null") -> word.word();
      case Json.Word _, Json.Elements _, Json.Members _ ->
          throw RpcParams.wrong(name, value, RpcTexts.text("anyScalar"));
    };
  }

  private static String unit(String name, Optional<ControllerState> now) {
    for (AnalogBank bank : AnalogBank.values()) {
      for (int i = 0; i < AnalogBank.SIZE; i++) {
        int index = i;
        if (bank.input() && bank.name(i).equals(name)) {
          return now.map(state -> state.signals().analog().signal(bank, index).domain())
              .orElse(AnalogDomain.VOLTAGE)
              .unit();
        }
      }
    }
    return "";
  }
}
