package org.pendant.desktop.unit;

import java.util.Arrays;
import org.pendant.kit.settings.Settings;

/** Form memory: remembers how people read poses from one start to the next. */
public final class FormMemory {
  private static final String LENGTH = "unit.length";
  private static final String ANGLE = "unit.angle";
  private static final String ROTATION = "unit.rotation";

  private FormMemory() {}

  /** The form chosen last. */
  public static PoseForm read(Settings settings) {
    PoseForm standard = PoseForm.STANDARD;
    return new PoseForm(
        unit(settings, LENGTH, DisplayUnit.Kind.LENGTH, standard.length()),
        unit(settings, ANGLE, DisplayUnit.Kind.ANGLE, standard.angle()),
        settings
            .get(ROTATION)
            .flatMap(
                name ->
                    Arrays.stream(RotationForm.values())
                        .filter(each -> each.name().equals(name))
                        .findAny())
            .orElse(standard.rotation()));
  }

  private static DisplayUnit unit(
      Settings settings, String key, DisplayUnit.Kind kind, DisplayUnit otherwise) {
    return settings.get(key).flatMap(text -> DisplayUnit.of(kind, text)).orElse(otherwise);
  }

  public static void write(Settings settings, PoseForm form) {
    settings.put(LENGTH, form.length().symbol());
    settings.put(ANGLE, form.angle().symbol());
    settings.put(ROTATION, form.rotation().name());
  }
}
