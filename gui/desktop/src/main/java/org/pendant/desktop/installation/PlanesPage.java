package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Planes page: planes that the tool must not pass. */
final class PlanesPage implements Page {
  private static final List<String> AXES = List.of("X", "Y", "Z");
  private static final String FROM_FEATURE = text("layOnFeature");

  private final Editing editing;
  private final SafetyDraft draft;
  private final TitledCard card =
      new TitledCard("safety-planes", text("safetyPlanes"), "[grow, fill]");
  private final SafetyBar bar;
  private final Items<SafetyPlane> items;
  private final JComboBox<String> fromFeature = new JComboBox<>();
  private boolean filling;

  PlanesPage(Editing editing, SafetyDraft draft, Supplier<ControllerState> state) {
    this.editing = editing;
    this.draft = draft;
    bar = new SafetyBar(draft, "planes");
    items =
        new Items<>(
            "plane",
            text("safetyPlanes"),
            text("noPlaneTheToolAndThe"),
            new Drafted(),
            each -> each.name() + "  (" + words(each.applies()) + ")");
    items.adder(
        "add-plane",
        text("addPlane"),
        () ->
            new SafetyPlane(
                items.freshName("Plane"), 0, 0, 0, new Axis(0, 0, 1), Applies.BOTH, false));
    PartsForm<SafetyPlane> form = items.form().in(editing.measures());
    form.text(
            "name",
            text("name"),
            SafetyPlane::name,
            (p, name) ->
                new SafetyPlane(
                    name.strip(),
                    p.pointXM(),
                    p.pointYM(),
                    p.pointZM(),
                    p.allowedSide(),
                    p.applies(),
                    p.elbow()))
        .<Applies>choice(
            "holds",
            text("holds"),
            now -> List.of(Applies.values()),
            PlanesPage::words,
            SafetyPlane::applies,
            (p, applies) ->
                new SafetyPlane(
                    p.name(),
                    p.pointXM(),
                    p.pointYM(),
                    p.pointZM(),
                    p.allowedSide(),
                    applies,
                    p.elbow()))
        .check(
            "elbow-as-well",
            text("elbowAsWell"),
            SafetyPlane::elbow,
            (p, elbow) ->
                new SafetyPlane(
                    p.name(),
                    p.pointXM(),
                    p.pointYM(),
                    p.pointZM(),
                    p.allowedSide(),
                    p.applies(),
                    elbow))
        .heading(text("aPointOfItInThe"));
    for (int i = 0; i < AXES.size(); i++) {
      int axis = i;
      form.numberRow(
          AXES.get(i),
          AXES.get(i),
          Measure.MILLIMETRE,
          now -> point(now)[axis],
          (p, m) -> {
            double[] point = point(p);
            point[axis] = m;
            return moved(p, point, p.allowedSide());
          });
    }
    form.heading(text("directionToTheAllowedSideAlong"));
    for (int i = 0; i < AXES.size(); i++) {
      int axis = i;
      form.numberRow(
          "side-" + AXES.get(i),
          text("side", AXES.get(i)),
          Measure.PLAIN,
          now -> side(now.allowedSide())[axis],
          (p, part) -> {
            double[] side = side(p.allowedSide());
            side[axis] = part;
            return moved(p, point(p), new Axis(side[0], side[1], side[2]));
          });
    }
    JButton here = new JButton(text("throughTcp"));
    TitledCard.compact(here);
    TitledCard.named(here, "plane-here", text("putThePlaneWhereTheTcp"));
    here.addActionListener(
        event ->
            items
                .chosen()
                .ifPresent(
                    p -> {
                      Pose tcp = state.get().arm().targetTcpInBase();
                      items.replace(
                          moved(p, new double[] {tcp.x(), tcp.y(), tcp.z()}, p.allowedSide()));
                    }));
    JButton turn = new JButton(text("otherSide"));
    TitledCard.compact(turn);
    TitledCard.named(turn, "plane-turn", text("allowTheOtherSide"));
    turn.addActionListener(
        event ->
            items
                .chosen()
                .ifPresent(
                    p -> {
                      double[] side = side(p.allowedSide());
                      items.replace(moved(p, point(p), new Axis(-side[0], -side[1], -side[2])));
                    }));
    form.buttons(here, turn);
    TitledCard.named(fromFeature, "plane-feature", text("layItOnTheXY"));
    fromFeature.addActionListener(event -> layOnFeature());
    form.wide(fromFeature);
    card.add(bar.component());
    card.add(items.component());
    form.whenNothing(draft::nothingTyped);
    draft.addListener(this::show);
  }

  /** The planes of the draft. */
  private final class Drafted implements Items.Model<SafetyPlane> {
    @Override
    public List<SafetyPlane> list() {
      return draft.shown().planes();
    }

    @Override
    public String refusal(List<SafetyPlane> next) {
      try {
        return draft.refusal(with(next));
      } catch (IllegalArgumentException e) {
        return Messages.shown(e.getMessage());
      }
    }

    private SafetyConfiguration with(List<SafetyPlane> next) {
      return draft.shown().withPlanes(next.toArray(new SafetyPlane[0]));
    }

    @Override
    public void take(
        List<SafetyPlane> next, Optional<SafetyPlane> before, Optional<SafetyPlane> after) {
      draft.edit(with(next));
    }

    @Override
    public boolean editable() {
      return draft.unlocked();
    }
  }

  private void layOnFeature() {
    int index = fromFeature.getSelectedIndex();
    if (filling || index <= 0) {
      return;
    }
    Optional<Pose> pose =
        editing.now().feature(fromFeature.getItemAt(index)).flatMap(FeaturePoses::pose);
    Optional<SafetyPlane> plane = items.chosen();
    if (pose.isPresent() && plane.isPresent()) {
      double[] transform = new double[Transforms.SIZE];
      Transforms.of(pose.get(), transform);
      items.replace(
          moved(
              plane.get(),
              new double[] {pose.get().x(), pose.get().y(), pose.get().z()},
              new Axis(transform[2], transform[5], transform[8])));
    }
    fromFeature.setSelectedIndex(0);
  }

  private static double[] point(SafetyPlane p) {
    return new double[] {p.pointXM(), p.pointYM(), p.pointZM()};
  }

  /** The numbers of a direction. */
  static double[] side(Axis axis) {
    return new double[] {axis.x(), axis.y(), axis.z()};
  }

  private static SafetyPlane moved(SafetyPlane p, double[] point, Axis side) {
    return new SafetyPlane(p.name(), point[0], point[1], point[2], side, p.applies(), p.elbow());
  }

  /** When something holds. */
  static String words(Applies applies) {
    return switch (applies) {
      case NORMAL -> text("inNormalMode");
      case REDUCED -> text("inReducedMode");
      case BOTH -> text("always");
      case TRIGGERS_REDUCED -> text("triggersReducedMode");
    };
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    bar.show();
    List<String> names = new ArrayList<>(List.of(FROM_FEATURE));
    editing.now().features().stream()
        .filter(each -> FeaturePoses.pose(each).isPresent())
        .map(Feature::name)
        .forEach(names::add);
    filling = true;
    fromFeature.removeAllItems();
    names.forEach(fromFeature::addItem);
    filling = false;
    items.show();
    enable(items.form().component(), draft.unlocked());
    fromFeature.setEnabled(draft.unlocked() && names.size() > 1);
  }

  /** Enables all that is in a form, or nothing. */
  static void enable(JComponent container, boolean on) {
    Arrays.stream(container.getComponents())
        .filter(each -> each instanceof JComponent)
        .map(JComponent.class::cast)
        .forEach(
            each -> {
              if (each instanceof javax.swing.JPanel) {
                enable(each, on);
              } else if (!(each instanceof javax.swing.JLabel)) {
                each.setEnabled(on);
              }
            });
  }
}
