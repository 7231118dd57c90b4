package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.PoseRows;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.pose.Pose;

/** Features page: frames that programs refer to by name, taught by the arm. */
final class FeaturesPage implements Page {
  private static final int MAX_POINTS = 3;

  private final Supplier<ControllerState> state;
  private final TitledCard card = new TitledCard("features", text("features"), "[grow, fill]");
  private final Items<Feature> items;
  private final List<JLabel> places = new ArrayList<>();
  private final List<JButton> teach = new ArrayList<>();
  private final List<JLabel> names = new ArrayList<>();
  private final JComboBox<String> typedPoint = new JComboBox<>();

  FeaturesPage(Editing editing, RotationChoice rotation, Supplier<ControllerState> state) {
    this.state = state;
    items =
        new Items<>(
            "feature",
            text("features"),
            text("noFeatureYetAFeatureIs"),
            new Listed<>(
                editing,
                Installation::features,
                (parts, all) -> parts.features = all,
                FeaturesPage::follow),
            each ->
                text(
                    FeaturePoses.pose(each).isPresent() ? "featureOfKind" : "unfinishedFeature",
                    each.name(),
                    words(each.kind())));
    for (FeatureKind kind : FeatureKind.values()) {
      String word = kind.name().toLowerCase(Locale.ROOT);
      items.adder(
          "add-" + word,
          switch (kind) {
            case POINT -> text("addPoint");
            case LINE -> text("addLine");
            case PLANE -> text("addPlaneFeature");
          },
          () ->
              new Feature(
                  items.freshName(
                      word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1)),
                  kind,
                  kind == FeatureKind.POINT ? List.of(tcp()) : List.of(),
                  false,
                  true));
    }
    PartsForm<Feature> form = items.form().in(editing.measures());
    form.text("name", text("name"), Feature::name, (f, name) -> with(f, name.strip(), f.points()))
        .check(
            "variable",
            text("variable"),
            Feature::variable,
            (f, on) -> new Feature(f.name(), f.kind(), f.points(), on, f.joggable()))
        .check(
            "joggable",
            text("joggable"),
            Feature::joggable,
            (f, on) -> new Feature(f.name(), f.kind(), f.points(), f.variable(), on))
        .remark(
            f ->
                FeaturePoses.pose(f).isPresent()
                    ? ""
                    : editing.problem("features[" + items.chosenIndex() + "].points").orElse(""))
        .heading(text("points"))
        .wide(points());
    TitledCard.named(typedPoint, "feature-typed", text("thePointThatIsTypedBelow"));
    typedPoint.addActionListener(event -> items.chosen().ifPresent(form::showOther));
    form.add(text("typePoint"), typedPoint);
    PoseRows.addTo(
        form,
        "feature-point",
        rotation,
        f -> index() < f.points().size() ? f.points().get(index()) : Pose.ZERO,
        (f, pose) -> with(f, f.name(), placed(f.points(), index(), pose)),
        f -> index() <= f.points().size());
    form.note(text("pointsArePosesOfTheTcp")).follow(this::showPoints);
    card.add(items.component());
    rotation.addListener(this::show);
  }

  private JComponent points() {
    JPanel grid =
        new JPanel(new MigLayout("insets 0, gap 8 4, wrap 3, hidemode 3", "[][grow, fill][]"));
    grid.setOpaque(false);
    for (int i = 0; i < MAX_POINTS; i++) {
      int point = i;
      JLabel name = new JLabel();
      JLabel place = new JLabel();
      place.setName("feature-place-" + i);
      JButton button = new JButton(text("setToTcp"));
      TitledCard.compact(button);
      TitledCard.named(button, "feature-teach-" + i, text("putThePointWhereTheTcp"));
      button.addActionListener(
          event ->
              items
                  .chosen()
                  .ifPresent(
                      f -> items.replace(with(f, f.name(), placed(f.points(), point, tcp())))));
      grid.add(name);
      grid.add(place, "wmin 0");
      grid.add(button);
      names.add(name);
      places.add(place);
      teach.add(button);
    }
    return grid;
  }

  private int index() {
    return Math.max(0, typedPoint.getSelectedIndex());
  }

  private Pose tcp() {
    return state.get().arm().targetTcpInBase();
  }

  private static List<Pose> placed(List<Pose> points, int index, Pose pose) {
    List<Pose> next = new ArrayList<>(points);
    if (index < next.size()) {
      next.set(index, pose);
    } else {
      next.add(pose);
    }
    return next;
  }

  private static Feature with(Feature f, String name, List<Pose> points) {
    return new Feature(name, f.kind(), points, f.variable(), f.joggable());
  }

  private static String words(FeatureKind kind) {
    return switch (kind) {
      case POINT -> text("point");
      case LINE -> text("line");
      case PLANE -> text("plane");
    };
  }

  private static List<String> pointNames(FeatureKind kind) {
    return switch (kind) {
      case POINT -> List.of(text("pose"));
      case LINE -> List.of(text("origin"), text("onYAxis"));
      case PLANE -> List.of(text("origin"), text("onXAxis"), text("towardsY"));
    };
  }

  private void showPoints(Feature feature) {
    List<String> wanted = pointNames(feature.kind());
    for (int i = 0; i < MAX_POINTS; i++) {
      boolean there = i < wanted.size();
      boolean taught = i < feature.points().size();
      names.get(i).setText(there ? wanted.get(i) : "");
      places.get(i).setText(taught ? words(feature.points().get(i)) : text("notTaughtYet"));
      names.get(i).setVisible(there);
      places.get(i).setVisible(there);
      teach.get(i).setVisible(there);
      teach.get(i).setEnabled(i <= feature.points().size());
      teach
          .get(i)
          .getAccessibleContext()
          .setAccessibleName(text("setToTheTcp", there ? wanted.get(i) : text("point")));
    }
    if (typedPoint.getItemCount() != wanted.size()
        || !wanted.getLast().equals(typedPoint.getItemAt(wanted.size() - 1))) {
      typedPoint.removeAllItems();
      wanted.forEach(typedPoint::addItem);
    }
  }

  private static String words(Pose pose) {
    return String.format(
        Locale.ROOT, "%.1f, %.1f, %.1f mm", pose.x() * 1000, pose.y() * 1000, pose.z() * 1000);
  }

  private static void follow(
      InstallationParts parts, Optional<Feature> before, Optional<Feature> after) {
    if (before.isEmpty() || after.isEmpty() || before.get().name().equals(after.get().name())) {
      return;
    }
    List<ConveyorSetup> next = new ArrayList<>();
    for (ConveyorSetup c : parts.conveyors) {
      next.add(
          c.feature().equals(before.get().name())
              ? new ConveyorSetup(
                  c.number(),
                  c.encoder(),
                  after.get().name(),
                  c.circular(),
                  c.ticksPerUnit(),
                  c.rotateTool(),
                  c.decoder(),
                  c.inputs())
              : c);
    }
    parts.conveyors = next;
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    items.show();
  }
}
