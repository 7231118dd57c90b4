package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogDirection.Kind;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.layout.TitledCard;

/** Jog pad: six buttons that move the tool along three axes, or turn it about them. */
final class Pad {
  /** By quarter turns counter-clockwise. */
  private static final List<String> ARROWS = List.of("right", "up", "left", "down");

  private final Kind kind;
  private final Consumer<JogDirection> press;
  private final Runnable letGo;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 4, wrap 4", "[][][]8[]", "[][][][]"));
  private final List<HoldButton> buttons = new ArrayList<>();

  /**
   * Buttons.
   *
   * @param press runs when one is pressed
   * @param letGo runs when it is let go
   */
  Pad(Kind kind, Consumer<JogDirection> press, Runnable letGo) {
    this.kind = kind;
    this.press = press;
    this.letGo = letGo;
    panel.setOpaque(false);
    JLabel heading = new JLabel(along() ? text("moveHeading") : text("turnHeading"));
    heading.putClientProperty("FlatLaf.styleClass", "small");
    panel.add(heading, "span 4, center");
    add('Y', 1, 1, "cell 1 1");
    add('X', -1, 2, "cell 0 2");
    add('X', 1, 0, "cell 2 2");
    add('Y', -1, 3, "cell 1 3");
    add('Z', 1, 1, "cell 3 1");
    add('Z', -1, 3, "cell 3 3");
  }

  private boolean along() {
    return kind == Kind.ALONG;
  }

  private void add(char axis, int sign, int quarters, String cell) {
    JogDirection direction = direction(kind, axis, sign);
    String drawing = along() ? ARROWS.get(quarters) : sign > 0 ? "counter-clockwise" : "clockwise";
    SvgIcon icon = SvgIcon.of("jog/" + drawing, 18);
    String text = (sign > 0 ? "+" : "\u2212") + (along() ? "" : "R") + axis;
    HoldButton button = new HoldButton(text, icon, () -> press.accept(direction), letGo);
    button.setHorizontalTextPosition(SwingConstants.CENTER);
    button.setVerticalTextPosition(SwingConstants.BOTTOM);
    button.setIconTextGap(0);
    button.putClientProperty("FlatLaf.style", "margin: 2,2,2,2; minimumWidth: 0");
    TitledCard.named(
        button,
        "move-"
            + (along() ? "" : "turn-")
            + Character.toLowerCase(axis)
            + (sign > 0 ? "-up" : "-down"),
        MoveTexts.text(along() ? "moveAlong" : "turnAbout", (sign > 0 ? "+" : "-") + axis));
    buttons.add(button);
    panel.add(button, cell + ", w 42::, h 42::, sg jog");
  }

  /** Along or about an axis X, Y or Z, or (sign -1) the other way. */
  static JogDirection direction(Kind kind, char axis, int sign) {
    return new JogDirection(
        kind, axis == 'X' ? sign : 0, axis == 'Y' ? sign : 0, axis == 'Z' ? sign : 0);
  }

  JComponent component() {
    return panel;
  }

  List<HoldButton> buttons() {
    return buttons;
  }
}
