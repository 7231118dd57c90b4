package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;

/**
 * Jog size: how far the arm moves when the user presses a button: as long as it is held, or by a
 * round number of the units that people have chosen.
 */
enum JogSize {
  /** As long as the button is held. */
  HELD("0", "0", "0", "0", text("actionHeld")),
  FINE("0.1", "0.0001", "0.005", "0.002", text("actionFine")),
  MEDIUM("1", "0.001", "0.05", "0.02", text("actionMedium")),
  COARSE("10", "0.01", "0.5", "0.2", text("actionCoarse"));

  private final String usual;
  private final String metres;
  private final String inches;
  private final String radians;
  private final String action;

  /**
   * A size.
   *
   * @param usual so many mm or deg
   * @param metres so many m, where lengths are shown in m
   * @param inches so many in, where lengths are shown in inches
   * @param radians so many rad, where angles are shown in rad
   * @param action what the action that chooses it says
   */
  JogSize(String usual, String metres, String inches, String radians, String action) {
    this.usual = usual;
    this.metres = metres;
    this.inches = inches;
    this.radians = radians;
    this.action = action;
  }

  /** One number stands for lengths and angles in these units. */
  static boolean shareNumbers(PoseForm form) {
    return FINE.number(form.length()).equals(FINE.number(form.angle()));
  }

  private String number(DisplayUnit unit) {
    return switch (unit) {
      case MILLIMETRE, DEGREE -> usual;
      case METRE -> metres;
      case INCH -> inches;
      case RADIAN -> radians;
      case KILOGRAM, GRAM, KILOGRAM_SQUARE_METRE ->
          throw new IllegalArgumentException("unit is " + unit + ", must be of a length or angle");
    };
  }

  private String words(DisplayUnit unit) {
    return number(unit) + " " + unit.symbol();
  }

  /**
   * What the button that chooses it says: a number for lengths, and one for angles if it differs.
   */
  String title(PoseForm form) {
    if (this == HELD) {
      return text("holdSize");
    }
    return shareNumbers(form) ? usual : text("sizes", number(form.length()), number(form.angle()));
  }

  /** What stands behind the buttons: units of lengths and angles. */
  static String units(PoseForm form) {
    return text("sizes", form.length().symbol(), form.angle().symbol());
  }

  /** What it means, as a sentence without its end. */
  String meaning(PoseForm form) {
    return this == HELD
        ? text("moveAsLongAsAButton")
        : text("moveByOrTurnBy", words(form.length()), words(form.angle()));
  }

  /** What the action that chooses it says, whatever the units. */
  String action() {
    return action;
  }

  /** The step in these units; none for {@link #HELD}. */
  JogStep step(PoseForm form) {
    return new JogStep(
        form.length().parse(number(form.length())), form.angle().parse(number(form.angle())));
  }
}
