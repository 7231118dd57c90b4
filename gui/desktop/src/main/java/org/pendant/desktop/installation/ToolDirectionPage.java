package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JComponent;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Tool direction page: how far the tool may be tilted. */
final class ToolDirectionPage implements Page {
  private static final ToolDirection DOWN =
      new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), Math.toRadians(45), Applies.BOTH);

  private static final List<String> AXES = List.of("X", "Y", "Z");

  private final SafetyDraft draft;
  private final TitledCard card =
      new TitledCard("tool-direction", text("toolDirection"), "[grow, fill]");
  private final SafetyBar bar;
  private final PartsForm<SafetyConfiguration> form;

  ToolDirectionPage(SafetyDraft draft) {
    this.draft = draft;
    bar = new SafetyBar(draft, "direction");
    form = new PartsForm<>("direction", draft::refusal, draft::edit);
    form.in(draft.measures());
    form.check(
        "restrict-how-far-the-tool-may-be-tilted",
        text("restrictHowFarTheToolMay"),
        c -> c.toolDirection().isPresent(),
        (c, on) -> with(c, on ? Optional.of(DOWN) : Optional.empty()));
    form.numberRow(
        "largest-angle",
        text("largestAngle"),
        Measure.DEGREE,
        c -> of(c).largestAngleRad(),
        (c, rad) ->
            change(
                c, d -> new ToolDirection(d.allowedInBase(), d.toolInFlange(), rad, d.applies())));
    form.<Applies>choice(
        "holds",
        text("holds"),
        now -> List.of(Applies.NORMAL, Applies.REDUCED, Applies.BOTH),
        PlanesPage::words,
        c -> of(c).applies(),
        (c, applies) ->
            change(
                c,
                d ->
                    new ToolDirection(
                        d.allowedInBase(), d.toolInFlange(), d.largestAngleRad(), applies)));
    form.heading(text("whereItShouldPointAlongThe"));
    axes(
        "base",
        "baseAxis",
        ToolDirection::allowedInBase,
        (d, axis) -> new ToolDirection(axis, d.toolInFlange(), d.largestAngleRad(), d.applies()));
    form.heading(text("theToolsOwnDirectionAlongThe"));
    axes(
        "flange",
        "flangeAxis",
        ToolDirection::toolInFlange,
        (d, axis) -> new ToolDirection(d.allowedInBase(), axis, d.largestAngleRad(), d.applies()));
    card.add(bar.component());
    card.add(form.component());
    form.whenNothing(draft::nothingTyped);
    draft.addListener(this::show);
  }

  /** Another direction in its place. */
  private interface Turn {
    ToolDirection with(ToolDirection before, Axis axis);
  }

  private void axes(String name, String title, Function<ToolDirection, Axis> get, Turn turn) {
    for (int i = 0; i < AXES.size(); i++) {
      int axis = i;
      form.numberRow(
          name + " " + AXES.get(i),
          text(title, AXES.get(i)),
          Measure.PLAIN,
          c -> PlanesPage.side(get.apply(of(c)))[axis],
          (c, part) ->
              change(
                  c,
                  d -> {
                    double[] side = PlanesPage.side(get.apply(d));
                    side[axis] = part;
                    return turn.with(d, new Axis(side[0], side[1], side[2]));
                  }));
    }
  }

  private static ToolDirection of(SafetyConfiguration c) {
    return c.toolDirection().orElse(DOWN);
  }

  private static SafetyConfiguration change(
      SafetyConfiguration c, Function<ToolDirection, ToolDirection> change) {
    return with(c, Optional.of(change.apply(of(c))));
  }

  private static SafetyConfiguration with(
      SafetyConfiguration c, Optional<ToolDirection> direction) {
    return new SafetyConfiguration(c.normal(), c.reduced(), c.planes(), direction);
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    bar.show();
    form.show(draft.shown());
    PlanesPage.enable(form.component(), draft.unlocked());
  }
}
