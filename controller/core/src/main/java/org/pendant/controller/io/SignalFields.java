package org.pendant.controller.io;

import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/** Signal fields: reads signals from files of the cell. */
public final class SignalFields {
  private SignalFields() {}

  /**
   * An input that must be there.
   *
   * @throws JsonException if it is none
   */
  public static Signal input(JsonFields fields, String key) throws JsonException {
    Json.Text text = fields.text(key);
    try {
      return Signal.input(text.value());
    } catch (IllegalArgumentException _) {
      throw text.place()
          .refusal(key + " is " + text.described() + ", must be an input, such as digital_in[0]");
    }
  }

  /**
   * A digital signal that must be there.
   *
   * @throws JsonException if it is none
   */
  public static Signal signal(JsonFields fields, String key) throws JsonException {
    Json.Text text = fields.text(key);
    try {
      return Signal.named(text.value());
    } catch (IllegalArgumentException _) {
      throw text.place()
          .refusal(key + " is " + text.described() + ", must be a signal, such as digital_out[0]");
    }
  }
}
