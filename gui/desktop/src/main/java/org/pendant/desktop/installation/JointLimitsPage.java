package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.kit.form.EntryField;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.arm.Joints;

/** Joint limits page: speeds and ranges of the joints, normal and reduced. */
final class JointLimitsPage implements Page {
  private static final String NONE = text("noLimit");
  static final List<String> NAMES =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

  private final SafetyDraft draft;
  private final TitledCard card =
      new TitledCard("joint-limits", text("jointLimits"), "[grow, fill]");
  private final SafetyBar bar;
  private final PartsForm<SafetyConfiguration> form;
  private final List<EntryField> fields = new ArrayList<>();
  private final List<Runnable> heads = new ArrayList<>();

  JointLimitsPage(SafetyDraft draft) {
    this.draft = draft;
    bar = new SafetyBar(draft, "joints");
    form = new PartsForm<>("joints", draft::refusal, draft::edit);
    form.in(draft.measures());
    form.heading(text("normal"));
    addSet("normal", SafetyConfiguration::normal, LimitsPage::withNormal);
    form.heading(text("reduced"));
    addSet(
        "reduced", SafetyConfiguration::reduced, (c, limits) -> c.withLimits(c.normal(), limits));
    form.note(text("noneNoLimitBut"));
    card.add(bar.component());
    card.add(form.component());
    form.whenNothing(draft::nothingTyped);
    draft.addListener(this::show);
  }

  private void addSet(
      String set,
      Function<SafetyConfiguration, SafetyLimits> get,
      BiFunction<SafetyConfiguration, SafetyLimits, SafetyConfiguration> with) {
    JPanel grid =
        new JPanel(
            new MigLayout(
                "insets 0, gap 8 6, wrap 4",
                "[]12[50:100:120, fill][50:100:120, fill][50:100:120, fill]"));
    grid.setOpaque(false);
    grid.add(new JLabel());
    head(grid, text("speed"), Measure.DEGREE_PER_S);
    head(grid, text("from"), Measure.DEGREE);
    head(grid, text("to"), Measure.DEGREE);
    List<EntryField> mine = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      EntryField speed =
          form.number(
              set + "-speed-" + i,
              text("speedOf", NAMES.get(i)),
              Measure.DEGREE_PER_S,
              now -> get.apply(now).jointSpeedRadPerS().get(joint),
              (c, value) -> {
                SafetyLimits l = get.apply(c);
                return with.apply(
                    c,
                    joints(
                        l,
                        l.jointSpeedRadPerS().with(joint, value),
                        l.jointMinRad(),
                        l.jointMaxRad()));
              });
      EntryField from =
          form.entry(
              set + "-from-" + i,
              text("rangeFrom", NAMES.get(i)),
              now -> words(get.apply(now).jointMinRad().get(joint), degrees()),
              (c, text) -> {
                SafetyLimits l = get.apply(c);
                Joints min = l.jointMinRad().with(joint, angle(text, Double.NEGATIVE_INFINITY));
                return with.apply(c, joints(l, l.jointSpeedRadPerS(), min, l.jointMaxRad()));
              });
      EntryField to =
          form.entry(
              set + "-to-" + i,
              text("rangeTo", NAMES.get(i)),
              now -> words(get.apply(now).jointMaxRad().get(joint), degrees()),
              (c, text) -> {
                SafetyLimits l = get.apply(c);
                Joints max = l.jointMaxRad().with(joint, angle(text, Double.POSITIVE_INFINITY));
                return with.apply(c, joints(l, l.jointSpeedRadPerS(), l.jointMinRad(), max));
              });
      from.setHorizontalAlignment(SwingConstants.TRAILING);
      to.setHorizontalAlignment(SwingConstants.TRAILING);
      JLabel label = new JLabel(NAMES.get(i));
      label.setLabelFor(speed);
      grid.add(label);
      for (EntryField each : List.of(speed, from, to)) {
        grid.add(each, "wmin 50, wmax 120");
        mine.add(each);
      }
    }
    form.grid(grid, mine);
    fields.addAll(mine);
  }

  /** A head of a column, with the unit that people have chosen. */
  private void head(JPanel grid, String title, Measure measure) {
    JLabel head = new JLabel();
    heads.add(() -> head.setText(text("head", title, draft.measures().of(measure).symbol())));
    heads.getLast().run();
    grid.add(head);
  }

  private static SafetyLimits joints(SafetyLimits l, Joints speed, Joints min, Joints max) {
    return LimitKind.limits(LimitKind.values(l), speed, min, max);
  }

  private double angle(String text, double none) {
    return text.strip().equals(NONE) ? none : degrees().parse(text);
  }

  private Measure degrees() {
    return draft.measures().of(Measure.DEGREE);
  }

  /** A limit of a range. */
  static String words(double rad, Measure measure) {
    return Double.isInfinite(rad) ? NONE : measure.text(rad);
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    bar.show();
    heads.forEach(Runnable::run);
    form.show(draft.shown());
    fields.forEach(each -> each.setEnabled(draft.unlocked()));
  }
}
