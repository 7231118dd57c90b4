package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/**
 * Device owner: finds out which controller of a cell a device belongs to: the one that its key
 * {@value #KEY} names, else the first one whose signal it has, else the first of all. Signals
 * without a name in front are those of this controller.
 */
final class DeviceOwner {
  /** Names the controller; only in cells of several. */
  static final String KEY = "controller";

  private DeviceOwner() {}

  /**
   * The number of the controller.
   *
   * @param controllers by their names; none where there is one alone
   * @throws JsonException if the key names none of them
   */
  static int of(JsonFields device, DeviceKind kind, List<String> controllers) throws JsonException {
    if (!controllers.isEmpty() && device.optional(KEY).isPresent()) {
      Json.Text name = device.text(KEY);
      if (!controllers.contains(name.value())) {
        throw name.place()
            .refusal(text("mustBeOneOf", KEY, name.described(), String.join(", ", controllers)));
      }
      return controllers.indexOf(name.value());
    }
    for (DeviceField field : kind.fields()) {
      Optional<Json> value = device.optional(field.key());
      if (field instanceof DeviceField.Wire
          && value.isPresent()
          && value.get() instanceof Json.Text text
          && text.value().indexOf('.') > 0
          && controllers.contains(text.value().substring(0, text.value().indexOf('.')))) {
        return controllers.indexOf(text.value().substring(0, text.value().indexOf('.')));
      }
    }
    return 0;
  }
}
