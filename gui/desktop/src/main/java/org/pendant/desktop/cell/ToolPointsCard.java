package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.ToolPoint;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Tool points card: the points of the tool that touch things. */
final class ToolPointsCard {
  private final SceneDraft draft;
  private final Measures measures;
  private final TitledCard card =
      new TitledCard(
          "points-of-the-tool-that-touch", text("pointsOfTheToolThatTouch"), "[grow, fill]");
  private final Items<ToolPoint> items;

  /**
   * @param measures in which lengths are shown
   */
  ToolPointsCard(SceneDraft draft, Measures measures) {
    this.draft = draft;
    this.measures = measures;
    items =
        new Items<>(
            "cell-tool",
            text("pointsOfTheTool"),
            text("noneTheActiveTcpTouchesThings"),
            new Drafted(),
            this::words);
    items.adder("add-point", text("addPoint"), () -> new ToolPoint(new Vector3(0, 0, 0.1), 0));
    PartsForm<ToolPoint> form =
        items.form().in(measures).telling(why -> ShownRange.of(why, measures));
    form.heading(text("whereItIsInTheFlange"));
    Axes.addTo(
        form,
        "",
        "",
        Measure.MILLIMETRE,
        ToolPoint::pointInFlangeM,
        (point, placeM) -> new ToolPoint(placeM, point.radiusM()));
    form.numberRow(
        "radius",
        text("radius"),
        Measure.MILLIMETRE,
        ToolPoint::radiusM,
        (point, radiusM) -> new ToolPoint(point.pointInFlangeM(), radiusM));
    card.add(items.component());
  }

  private String words(ToolPoint point) {
    Vector3 at = point.pointInFlangeM();
    Measure unit = measures.of(Measure.MILLIMETRE);
    return "%s, %s, %s".formatted(unit.text(at.x()), unit.text(at.y()), unit.words(at.z()));
  }

  /** The points of the draft. */
  private final class Drafted implements Items.Model<ToolPoint> {
    @Override
    public List<ToolPoint> list() {
      return draft.scene().toolPoints();
    }

    @Override
    public String refusal(List<ToolPoint> next) {
      return SceneRefusal.of(() -> with(next), draft, draft.equipment());
    }

    private Scene with(List<ToolPoint> next) {
      Scene now = draft.scene();
      return now.withToolPoints(next);
    }

    @Override
    public void take(List<ToolPoint> next, Optional<ToolPoint> before, Optional<ToolPoint> after) {
      draft.set(with(next));
    }
  }

  JComponent component() {
    return card;
  }

  /** Shows the draft. */
  void show() {
    items.show();
  }
}
