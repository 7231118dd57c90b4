package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.kit.form.EntryField;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.arm.Joints;
import org.pendant.text.Language;

/** Limits page: the limits of the robot as a whole, normal and reduced. */
final class LimitsPage implements Page {
  private final Editing editing;
  private final SafetyDraft draft;
  private final TitledCard card =
      new TitledCard("safety-limits", text("safetyLimits"), "[grow, fill]");
  private final SafetyBar bar;
  private final PartsForm<SafetyConfiguration> form;
  private final List<JComponent> locked = new ArrayList<>();

  LimitsPage(Editing editing, SafetyDraft draft) {
    this.editing = editing;
    this.draft = draft;
    bar = new SafetyBar(draft, "limits");
    form = new PartsForm<>("limits", draft::refusal, draft::edit);
    form.in(draft.measures());
    JPanel grid =
        new JPanel(
            new MigLayout(
                "insets 0, gap 8 6, wrap 4",
                "[]12[60:110:130, fill][60:110:130, fill][grow, left]"));
    grid.setOpaque(false);
    grid.add(new JLabel());
    grid.add(new JLabel(text("normal")));
    grid.add(new JLabel(text("reduced")));
    grid.add(new JLabel());
    List<EntryField> fields = new ArrayList<>();
    for (LimitKind kind : LimitKind.values()) {
      String name = kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
      EntryField normal =
          form.number(
              "normal-" + name,
              text("normalLimit", Language.ofProcess().withinSentence(kind.title())),
              kind.unit(),
              now -> kind.of(now.normal()),
              (c, value) -> withNormal(c, kind.with(c.normal(), value)));
      EntryField reduced =
          form.number(
              "reduced-" + name,
              text("reducedLimit", Language.ofProcess().withinSentence(kind.title())),
              kind.unit(),
              now -> kind.of(now.reduced()),
              (c, value) -> c.withLimits(c.normal(), kind.with(c.reduced(), value)));
      JLabel label = new JLabel(kind.title());
      label.setLabelFor(normal);
      grid.add(label);
      grid.add(normal, "wmin 60, wmax 140");
      grid.add(reduced, "wmin 60, wmax 140");
      grid.add(form.unit(kind.unit()));
      fields.add(normal);
      fields.add(reduced);
    }
    form.grid(grid, fields);
    JButton standard = preset("standard", 1);
    JButton half = preset("half", 0.5);
    JButton quarter = preset("quarter", 0.25);
    form.heading(text("presets")).buttons(standard, half, quarter);
    form.note(text("standardIsWhatTheArmsData"));
    locked.addAll(fields);
    locked.addAll(List.of(standard, half, quarter));
    card.add(bar.component());
    card.add(form.component());
    form.whenNothing(draft::nothingTyped);
    draft.addListener(this::show);
  }

  /** Reduced limits are never wider than the normal ones. */
  static SafetyConfiguration withNormal(SafetyConfiguration c, SafetyLimits normal) {
    return c.withLimits(normal, LimitKind.within(c.reduced(), normal));
  }

  private JButton preset(String id, double part) {
    String title = text(id);
    JButton button = new JButton(title);
    TitledCard.compact(button);
    TitledCard.named(button, "limits-" + id, text("ofTheLimits", title));
    button.addActionListener(event -> draft.edit(scaled(part)));
    return button;
  }

  private SafetyConfiguration scaled(double part) {
    SafetyConfiguration standard = SafetyConfiguration.standard(editing.arm());
    SafetyConfiguration now = draft.shown();
    return now.withLimits(scaled(standard.normal(), part), scaled(standard.reduced(), part));
  }

  private static SafetyLimits scaled(SafetyLimits limits, double part) {
    Map<LimitKind, Double> v = LimitKind.values(limits);
    for (LimitKind each :
        List.of(LimitKind.POWER, LimitKind.MOMENTUM, LimitKind.TOOL_SPEED, LimitKind.ELBOW_SPEED)) {
      v.put(each, part * each.of(limits));
    }
    double[] speed = limits.jointSpeedRadPerS().toArray();
    for (int i = 0; i < speed.length; i++) {
      speed[i] *= part;
    }
    return LimitKind.limits(v, Joints.of(speed), limits.jointMinRad(), limits.jointMaxRad());
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    bar.show();
    form.show(draft.shown());
    locked.forEach(each -> each.setEnabled(draft.unlocked()));
  }
}
