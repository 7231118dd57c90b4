package org.pendant.gui.move;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractAction;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogDirection.Kind;
import org.pendant.controller.jog.JogFrame;
import org.pendant.gui.layout.Card;
import org.pendant.gui.workbench.Palette;

/** The pads that move and turn the tool, by mouse, finger or keys. */
final class JogCard {
  private static final String HINT =
      "Keys: arrows for X and Y, page up and down for Z; with Shift they turn the tool.";

  private final MovePresenter presenter;
  private final Card card = new Card("Tool", "[grow, fill]");
  private final List<HoldButton> buttons = new ArrayList<>();
  private final JLabel speed = new JLabel();
  private final Remark hint = new Remark("move-jog-hint", Palette::quiet);
  private final Remark reason = new Remark("move-jog-reason", Palette::warning);

  JogCard(MovePresenter presenter) {
    this.presenter = presenter;
    card.add(choices(), "grow");
    JPanel pads = new JPanel(new MigLayout("insets 0, gap 24 0", "[center, grow][center, grow]"));
    pads.setOpaque(false);
    pads.add(pad("Move", Kind.ALONG));
    pads.add(pad("Turn", Kind.AROUND));
    card.add(pads, "grow, gaptop 8");
    card.add(reason, Remark.LAYOUT);
    card.add(hint, Remark.LAYOUT);
    hint.say(HINT);
    bindKeys();
  }

  JComponent component() {
    return card;
  }

  private JComponent choices() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][]0[]16[][grow, fill][]"));
    row.setOpaque(false);
    ButtonGroup group = new ButtonGroup();
    row.add(new JLabel("Axes of"));
    row.add(frame("Base", JogFrame.BASE, group, true));
    row.add(frame("Tool", JogFrame.TOOL, group, false));
    JSlider slider = new JSlider(1, 100, (int) Math.round(100 * presenter.speedFraction()));
    Card.named(
        slider, "move-speed", "Speed of moves by hand; all of it is 250 mm/s, or 34 deg/s a joint");
    slider.addChangeListener(event -> setSpeed(slider.getValue()));
    JLabel label = new JLabel("Speed");
    label.setLabelFor(slider);
    row.add(label);
    row.add(slider, "wmin 60, w 100");
    speed.setHorizontalAlignment(SwingConstants.TRAILING);
    speed.setName("move-speed-text");
    row.add(speed, "wmin pref, sg percent");
    setSpeed(slider.getValue());
    return row;
  }

  private void setSpeed(int percent) {
    presenter.setSpeedFraction(percent / 100.0);
    speed.setText(percent + " %");
  }

  private JToggleButton frame(String text, JogFrame frame, ButtonGroup group, boolean chosen) {
    JToggleButton button = new JToggleButton(text, chosen);
    String tip = "Move and turn the tool along the axes of the " + text.toLowerCase(Locale.ROOT);
    Card.named(button, "move-frame-" + text.toLowerCase(Locale.ROOT), tip);
    button.addActionListener(event -> presenter.setFrame(frame));
    group.add(button);
    return button;
  }

  private JComponent pad(String title, Kind kind) {
    JPanel pad = new JPanel(new MigLayout("insets 0, gap 4, wrap 4", "[][][]12[]", "[][][][]"));
    pad.setOpaque(false);
    JLabel heading = new JLabel(title);
    heading.putClientProperty("FlatLaf.styleClass", "small");
    pad.add(heading, "span 4, center");
    add(pad, kind, 'Y', 1, 1, "cell 1 1");
    add(pad, kind, 'X', -1, 2, "cell 0 2");
    add(pad, kind, 'X', 1, 0, "cell 2 2");
    add(pad, kind, 'Y', -1, 3, "cell 1 3");
    add(pad, kind, 'Z', 1, 1, "cell 3 1");
    add(pad, kind, 'Z', -1, 3, "cell 3 3");
    return pad;
  }

  private void add(JPanel pad, Kind kind, char axis, int sign, int quarters, String cell) {
    JogDirection direction = direction(kind, axis, sign);
    boolean along = kind == Kind.ALONG;
    JogIcon icon =
        along
            ? new JogIcon(JogIcon.Form.STRAIGHT, quarters)
            : new JogIcon(
                sign > 0 ? JogIcon.Form.COUNTER_CLOCKWISE : JogIcon.Form.CLOCKWISE, quarters);
    String text = (sign > 0 ? "+" : "\u2212") + (along ? "" : "R") + axis;
    HoldButton button =
        new HoldButton(text, icon, () -> presenter.holdTool(direction), presenter::release);
    button.setHorizontalTextPosition(SwingConstants.CENTER);
    button.setVerticalTextPosition(SwingConstants.BOTTOM);
    button.setIconTextGap(0);
    button.putClientProperty("FlatLaf.style", "margin: 2,2,2,2; minimumWidth: 0");
    Card.named(
        button,
        "move-"
            + (along ? "" : "turn-")
            + Character.toLowerCase(axis)
            + (sign > 0 ? "-up" : "-down"),
        "Hold to " + (along ? "move along " : "turn about ") + (sign > 0 ? "+" : "-") + axis);
    buttons.add(button);
    pad.add(button, cell + ", w 46::, h 46::, sg jog");
  }

  private static JogDirection direction(Kind kind, char axis, int sign) {
    return new JogDirection(
        kind, axis == 'X' ? sign : 0, axis == 'Y' ? sign : 0, axis == 'Z' ? sign : 0);
  }

  private void bindKeys() {
    bind("RIGHT", 'X', 1);
    bind("LEFT", 'X', -1);
    bind("UP", 'Y', 1);
    bind("DOWN", 'Y', -1);
    bind("PAGE_UP", 'Z', 1);
    bind("PAGE_DOWN", 'Z', -1);
    FocusAdapter letGo =
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            presenter.release();
          }
        };
    buttons.forEach(each -> each.addFocusListener(letGo));
  }

  private void bind(String key, char axis, int sign) {
    JogDirection move = direction(Kind.ALONG, axis, sign);
    JogDirection turn = direction(Kind.AROUND, axis, sign);
    bind(key, () -> presenter.holdTool(move));
    bind("shift " + key, () -> presenter.holdTool(turn));
    bind("released " + key, presenter::release);
    bind("shift released " + key, presenter::release);
  }

  /** Keys belong to the pads alone: in sliders and fields they do what they do everywhere. */
  private void bind(String key, Runnable run) {
    for (HoldButton button : buttons) {
      button.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
      button
          .getActionMap()
          .put(
              key,
              new AbstractAction() {
                private static final long serialVersionUID = 1L;

                @Override
                public void actionPerformed(ActionEvent event) {
                  run.run();
                }
              });
    }
  }

  void refresh() {
    buttons.forEach(each -> each.setEnabled(presenter.movable()));
    String sentence = JointNames.sentence(presenter.jogReason());
    reason.say(sentence);
    hint.say(sentence.isEmpty() ? HINT : "");
  }
}
