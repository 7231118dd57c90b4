package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.jog.JogDirection.Kind;
import org.pendant.controller.jog.Jogging;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/** Jog card: the pads that move and turn the tool, by mouse, finger or keys, and how they do it. */
final class JogCard {
  private static final String HINT = text("keysArrowsForXAndY");

  private final JogPresenter presenter;
  private final TitledCard card = new TitledCard("tool", text("toolCard"), "[grow, fill]");
  private final List<HoldButton> buttons = new ArrayList<>();
  private final Segments<JogAxes> axes;
  private final Segments<JogSize> sizes;
  private PoseForm form;
  private final JLabel units = new JLabel();

  /** Below buttons with two numbers each, beside which there is no room. */
  private final JLabel unitsBelow = new JLabel();

  private final JSlider slider;
  private final JLabel speed = new JLabel();
  private final Remark note = new Remark("move-jog-reason", this::noteColor);

  JogCard(JogPresenter presenter) {
    this.presenter = presenter;
    form = presenter.form();
    axes =
        new Segments<>(
            JogAxes.class,
            presenter.axes(),
            "move-frame-",
            JogAxes::title,
            each -> text("moveAndTurnTheToolAlong", each.meaning()),
            presenter::setAxes);
    sizes =
        new Segments<>(
            JogSize.class,
            presenter.size(),
            "move-step-",
            each -> each.title(form),
            each -> each.meaning(form),
            presenter::setSize);
    slider = new JSlider(1, 100, (int) Math.round(100 * presenter.speedFraction()));
    Pad along = new Pad(Kind.ALONG, presenter::move, presenter::letGo);
    Pad around = new Pad(Kind.AROUND, presenter::move, presenter::letGo);
    buttons.addAll(along.buttons());
    buttons.addAll(around.buttons());
    card.add(choices(), "grow");
    JPanel pads = new JPanel(new MigLayout("insets 0, gap 16 0", "[center, grow][center, grow]"));
    pads.setOpaque(false);
    pads.add(along.component());
    pads.add(around.component());
    card.add(pads, "grow, gaptop 8");
    // as high for either text: nothing below moves under a hand that holds
    note.setRows(2);
    card.add(note, Remark.LAYOUT);
    note.say(HINT);
    JogKeys.bindTo(buttons, presenter);
  }

  JComponent component() {
    return card;
  }

  private JComponent choices() {
    JPanel grid = new JPanel(new MigLayout("insets 0, gap 8 6, wrap", "[][grow, fill]"));
    grid.setOpaque(false);
    grid.add(new JLabel(text("axesOf")));
    grid.add(axes.component(), "growx 0");
    grid.add(new JLabel(text("step")));
    grid.add(steps(), "growx 0");
    writeUnits();
    slider.addChangeListener(event -> setSpeed(slider.getValue()));
    JLabel label = new JLabel(text("speed"));
    label.setLabelFor(slider);
    grid.add(label);
    grid.add(slider, "split 2, wmin 60, w 100, growx, pushx");
    speed.setHorizontalAlignment(SwingConstants.TRAILING);
    speed.setName("move-speed-text");
    grid.add(speed, "w 48!, growx 0");
    setSpeed(slider.getValue());
    return grid;
  }

  private JComponent steps() {
    JPanel steps = new JPanel(new MigLayout("insets 0, gap 8 2, hidemode 3"));
    steps.setOpaque(false);
    steps.add(sizes.component(), "cell 0 0");
    steps.add(units, "cell 1 0");
    steps.add(unitsBelow, "cell 0 1");
    units.setForeground(Palette.quiet());
    unitsBelow.setForeground(Palette.quiet());
    return steps;
  }

  /** Says sizes and speeds in the units of people. */
  private void writeUnits() {
    form = presenter.form();
    sizes.write(each -> each.title(form), each -> each.meaning(form));
    units.setText(JogSize.units(form));
    units.setVisible(JogSize.shareNumbers(form));
    unitsBelow.setText(JogSize.units(form));
    unitsBelow.setVisible(!units.isVisible());
    String most =
        text(
            "speedOfMovesByHandAll",
            brief(Measure.MILLIMETRE_PER_S, Jogging.TOOL_SPEED_M_PER_S),
            brief(Measure.DEGREE_PER_S, Jogging.JOINT_SPEED_RAD_PER_S));
    TitledCard.named(slider, "move-speed", most);
  }

  private String brief(Measure usual, double value) {
    Measure shown = ShownMeasure.of(usual, form);
    return shown.brief(value) + " " + shown.symbol();
  }

  private void setSpeed(int percent) {
    presenter.setSpeedFraction(percent / 100.0);
    speed.setText(percent + " %");
  }

  void refresh() {
    if (!presenter.form().equals(form)) {
      writeUnits();
    }
    axes.show(presenter.axes());
    sizes.show(presenter.size());
    buttons.forEach(each -> each.setEnabled(presenter.movable()));
    String sentence = JointNames.sentence(presenter.reason());
    note.say(sentence.isEmpty() ? HINT : sentence);
  }

  private Color noteColor() {
    return presenter.reason().isEmpty() ? Palette.quiet() : Palette.warning();
  }
}
