package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.List;
import org.pendant.desktop.session.NumberedJoints;
import org.pendant.desktop.session.StateWords;
import org.pendant.kit.text.Messages;

/** Joint names: the joints by name instead of number. */
final class JointNames {
  private static final List<String> NAMES =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

  private static final List<String> NAMES_IN_SENTENCES =
      List.of(
          text("baseInSentence"),
          text("shoulderInSentence"),
          text("elbowInSentence"),
          text("wrist1InSentence"),
          text("wrist2InSentence"),
          text("wrist3InSentence"));
  private static final List<String> IDS =
      List.of("base", "shoulder", "elbow", "wrist-1", "wrist-2", "wrist-3");

  private JointNames() {}

  /** The name of a joint, 0 to 5. */
  static String of(int joint) {
    return NAMES.get(joint);
  }

  /** The name of a joint, 0 to 5, in names of components: the same in each language. */
  static String id(int joint) {
    return IDS.get(joint);
  }

  /** What is wrong with the position of a joint, 0 to 5. */
  static String problem(int joint, String problem) {
    return text("jointProblem", of(joint), problem);
  }

  /** What the controller says, as a sentence with names for {@code joint 0} to {@code joint 5}. */
  static String sentence(String reason) {
    String named = NumberedJoints.named(Messages.shown(reason), NAMES_IN_SENTENCES::get);
    return reason.isEmpty() ? "" : text("sentence", StateWords.capital(named));
  }
}
