package org.pendant.models.arm;

import java.io.InputStream;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Arm file: the description of one arm in a file of people's own, in the layout of the library's.
 * Its id names the model that the arm is one of.
 */
public final class ArmFile {
  private ArmFile() {}

  /**
   * Reads a description.
   *
   * @param name of the file, for messages
   * @throws JsonException if it is none; the message says where and why
   */
  public static ArmDescription read(String name, InputStream in) throws JsonException {
    JsonFields root = new JsonFields(JsonFile.read(name, in), ArmTexts.text("anArm"));
    Json.Text id = root.text("id");
    if (!ArmLibrary.ids().contains(id.value())) {
      throw id.place()
          .refusal(
              ArmTexts.text(
                  "wrongId", Json.quoted(id.value()), String.join(", ", ArmLibrary.ids())));
    }
    return DescriptionReader.read(root);
  }

  /** The text of a file from which {@link #read} gives {@code arm}, its calibration apart. */
  public static String text(ArmDescription arm) {
    return DescriptionWriter.text(arm);
  }
}
