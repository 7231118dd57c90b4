package org.pendant.desktop.move;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.pendant.desktop.session.StateWords;

/** Joint names: the joints by name instead of number. */
final class JointNames {
  private static final List<String> NAMES =
      List.of("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3");

  private static final Pattern NUMBERED = Pattern.compile("\\bjoint ([0-5])\\b");

  private JointNames() {}

  /** The name of a joint, 0 to 5. */
  static String of(int joint) {
    return NAMES.get(joint);
  }

  /** What the controller says, as a sentence with names for {@code joint 0} to {@code joint 5}. */
  static String sentence(String reason) {
    String named =
        NUMBERED
            .matcher(reason)
            .replaceAll(
                found -> NAMES.get(Integer.parseInt(found.group(1))).toLowerCase(Locale.ROOT));
    return reason.isEmpty() ? "" : StateWords.capital(named) + ".";
  }
}
