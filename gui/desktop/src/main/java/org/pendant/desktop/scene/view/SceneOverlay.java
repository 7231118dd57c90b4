package org.pendant.desktop.scene.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.desktop.scene.DeviceOutlines;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.SafetyOutlines;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.Sheets;
import org.pendant.desktop.scene.SpeedColours;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.theme.Palette;
import org.pendant.models.pose.Pose;

/**
 * Scene overlay: what is written on the picture: the scale of speeds, names of frames, what the
 * pointer is on.
 */
final class SceneOverlay {
  private static final List<String> JOINT_FRAMES =
      List.of("J1", "J2", "J3", "J4", "J5", "J6, flange");

  /** Of more of them few would have room. */
  private static final int MAX_PLACE_NAMES = 60;

  /** Points that are no farther apart share a name. */
  private static final double SAME_PLACE_EM = 0.3;

  private static final int MIN_WIDTH_FOR_LEGEND = 150;

  /** Of a picture that is lower still, what is covered counts for no more. */
  private static final double MAX_COVERED_SHARE = 0.3;

  private static final int SEEN_THROUGH = 215;
  private static final int OPAQUE = 255;
  private static final double NEAR_POINTER_EM = 1.2;

  private final Graphics2D graphics;
  private final int width;
  private final int height;
  private final PoseForm form;
  private final FontMetrics metrics;
  private final int em;

  /**
   * @param graphics at the scale of the component, with its font
   * @param form in whose units numbers are written
   */
  SceneOverlay(Graphics2D graphics, int width, int height, PoseForm form) {
    this.graphics = graphics;
    this.width = width;
    this.height = height;
    this.form = form;
    metrics = graphics.getFontMetrics();
    em = graphics.getFont().getSize();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
  }

  /** The colours of the trace and what they mean; nothing while there is no trace. */
  void legend(SceneModel model) {
    Optional<Rectangle2D> box = legendBox(model);
    if (box.isEmpty()) {
      return;
    }
    plate(box.get().getX(), box.get().getY(), box.get().getWidth(), box.get().getHeight());
    int bar = legendBar();
    int thick = legendThickness();
    int left = em;
    int bottom = height - em;
    TraceScale scale = TraceScale.of(model.trace(), form);
    int top = bottom - thick - metrics.getHeight();
    for (int x = 0; x < bar; x++) {
      double place = (x + 0.5) / bar;
      graphics.setColor(new Color(SpeedColours.rgb(place * place)));
      graphics.fillRect(left + x, top, 1, thick);
    }
    int base = bottom - metrics.getDescent();
    graphics.setColor(Palette.quiet());
    graphics.drawString(scale.least(), left, base);
    centred(scale.middle(), left + bar * SpeedColours.place(0.25), base);
    centred(scale.most(), left + bar - em / 2.0, base);
  }

  /** The names of compared ways beside their colours; nothing while there are none. */
  void compared(SceneModel model) {
    Optional<Rectangle2D> box = comparedBox(model);
    if (box.isEmpty()) {
      return;
    }
    plate(box.get().getX(), box.get().getY(), box.get().getWidth(), box.get().getHeight());
    double base = box.get().getY() + em / 4.0 + metrics.getAscent();
    for (ComparedWays.Entry each : model.compared().legend()) {
      double high = each.chosen() ? em / 2.0 : em / 4.0;
      double middle = base - metrics.getAscent() / 2.5;
      graphics.setColor(new Color(each.rgb()));
      graphics.fill(
          new Rectangle2D.Double(box.get().getX() + em / 2.0, middle - high / 2, 1.5 * em, high));
      graphics.setColor(Palette.dark() ? Color.WHITE : Color.BLACK);
      graphics.drawString(each.name(), (float) (box.get().getX() + 2.5 * em), (float) base);
      base += metrics.getHeight();
    }
  }

  /** Above the legend of the trace. */
  private Optional<Rectangle2D> comparedBox(SceneModel model) {
    List<ComparedWays.Entry> entries = model.compared().legend();
    if (entries.isEmpty() || width < MIN_WIDTH_FOR_LEGEND) {
      return Optional.empty();
    }
    double bottom = legendBox(model).map(Rectangle2D::getY).orElse((double) height);
    double wide =
        3 * em
            + entries.stream().mapToInt(each -> metrics.stringWidth(each.name())).max().orElse(0);
    double high = entries.size() * metrics.getHeight() + em / 2.0;
    return Optional.of(new Rectangle2D.Double(em / 2.0, bottom - em / 2.0 - high, wide, high));
  }

  private int legendBar() {
    return Math.min(11 * em, width - 5 * em);
  }

  private int legendThickness() {
    return Math.max(4, em / 2);
  }

  private Optional<Rectangle2D> legendBox(SceneModel model) {
    if (!model.trace().hasLine() || width < MIN_WIDTH_FOR_LEGEND) {
      return Optional.empty();
    }
    int wide =
        legendBar() - em / 2 + metrics.stringWidth(TraceScale.of(model.trace(), form).most()) / 2;
    int high = legendThickness() + metrics.getHeight() + em / 2;
    return Optional.of(
        new Rectangle2D.Double(em / 2.0, height - em - high, wide + em, high + em / 2.0));
  }

  /** What is covered at the top, as a share of the height. */
  double topShare(SceneModel model) {
    return share(doorsBox(model).map(Rectangle2D::getMaxY).orElse(0.0));
  }

  /** What is covered at the bottom, as a share of the height. */
  double bottomShare(SceneModel model) {
    return share(
        comparedBox(model).or(() -> legendBox(model)).map(box -> height - box.getY()).orElse(0.0));
  }

  private double share(double high) {
    return height == 0 ? 0 : Math.min(MAX_COVERED_SHARE, high / height);
  }

  private void centred(String text, double x, int base) {
    graphics.drawString(text, (float) (x - metrics.stringWidth(text) / 2.0), base);
  }

  /** Names beside places and frames, each where it can be read; returns where they stand. */
  List<LabelPlaces.Placed> names(PictureRequest shown) {
    List<LabelPlaces.Label> labels = new ArrayList<>();
    List<WaypointMarkers.Mark> marks = shown.model().waypointMarkers().marks();
    for (int i = 0; i < marks.size(); i++) {
      WaypointMarkers.Mark mark = marks.get(i);
      if (mark.chosen() || i < MAX_PLACE_NAMES) {
        add(labels, shown, mark.name(), place(mark.inBase()), i, mark.chosen());
      }
    }
    List<Pose> frames = shown.model().framesInBase();
    for (int i = 0; i < frames.size() && i < JOINT_FRAMES.size(); i++) {
      add(labels, shown, JOINT_FRAMES.get(i), place(frames.get(i)), -1, false);
    }
    addSafety(labels, shown);
    addSensors(labels, shown);
    addLamps(labels, shown);
    List<LabelPlaces.Placed> placed =
        LabelPlaces.of(
            labels,
            em,
            chipHeight(1),
            this::chipWidth,
            new Rectangle2D.Double(0, 0, width, height),
            Stream.of(legendBox(shown.model()), comparedBox(shown.model()), doorsBox(shown.model()))
                .flatMap(Optional::stream)
                .toList());
    placed.stream().filter(LabelPlaces.Placed::apart).forEach(this::line);
    for (LabelPlaces.Placed each : placed) {
      chip(each.label().text(), each.box().getX(), each.box().getY());
    }
    return placed;
  }

  /** Names of one place share a plate. */
  private void add(
      List<LabelPlaces.Label> labels,
      PictureRequest shown,
      String name,
      Vector3 place,
      int mark,
      boolean chosen) {
    Optional<Point2D> at = shown.camera().pixel(place, width, height);
    if (at.isEmpty()) {
      return;
    }
    for (int i = 0; i < labels.size(); i++) {
      LabelPlaces.Label other = labels.get(i);
      if (other.at().distance(at.get()) < SAME_PLACE_EM * em) {
        String both = other.text() + ", " + name;
        labels.set(
            i,
            new LabelPlaces.Label(
                both, other.at(), chosen ? mark : other.mark(), chosen || other.chosen()));
        return;
      }
    }
    labels.add(new LabelPlaces.Label(name, at.get(), mark, chosen));
  }

  private void addSafety(List<LabelPlaces.Label> labels, PictureRequest shown) {
    SafetySight safety = shown.model().safety();
    for (SafetySight.Plane each : safety.planes()) {
      Sheets.namePlaces(each.plane(), shown.model()).stream()
          .filter(place -> inSight(shown, place))
          .findFirst()
          .ifPresent(place -> add(labels, shown, each.words(), place, -1, each.state().named()));
    }
    for (SafetySight.Range each : safety.joints()) {
      Vector3 place = SafetyOutlines.namePlace(each, shown.model());
      add(labels, shown, each.words(form.angle()), place, -1, each.state().named());
    }
  }

  private void addSensors(List<LabelPlaces.Label> labels, PictureRequest shown) {
    for (DeviceSight.Sensor each : shown.model().devices().sensors()) {
      Vector3 place = DeviceOutlines.namePlace(shown.model().devices(), each.zone());
      if (inSight(shown, place)) {
        add(labels, shown, each.name(), place, -1, each.sees());
      }
    }
  }

  private void addLamps(List<LabelPlaces.Label> labels, PictureRequest shown) {
    for (DeviceSight.Lamp each : shown.model().devices().lamps()) {
      Vector3 place = place(each.inBase());
      if (inSight(shown, place)) {
        add(labels, shown, each.name(), place, -1, each.lit());
      }
    }
  }

  /** How far doors are open, which have no place in the picture. */
  void doors(SceneModel model) {
    doorsBox(model)
        .ifPresent(
            box -> chip(String.join("\n", doorWords(model).toList()), box.getX(), box.getY()));
  }

  private static Stream<String> doorWords(SceneModel model) {
    return model.devices().doors().stream().map(DeviceSight.Door::words);
  }

  /** In the left corner at the top. */
  private Optional<Rectangle2D> doorsBox(SceneModel model) {
    int doors = model.devices().doors().size();
    String all = String.join("\n", doorWords(model).toList());
    return doors == 0 || width < MIN_WIDTH_FOR_LEGEND
        ? Optional.empty()
        : Optional.of(
            new Rectangle2D.Double(em / 2.0, em / 2.0, chipWidth(all), chipHeight(doors)));
  }

  private boolean inSight(PictureRequest shown, Vector3 place) {
    return shown
        .camera()
        .pixel(place, width, height)
        .filter(new Rectangle2D.Double(0, 0, width, height)::contains)
        .isPresent();
  }

  private static Vector3 place(Pose pose) {
    return new Vector3(pose.x(), pose.y(), pose.z());
  }

  /** From a name to its point. */
  private void line(LabelPlaces.Placed name) {
    Point2D point = name.label().at();
    graphics.setColor(Palette.quiet());
    graphics.setStroke(new BasicStroke(1));
    graphics.draw(new Line2D.Double(LabelPlaces.nearest(name.box(), point), point));
    double dot = em / 6.0;
    graphics.fill(new Ellipse2D.Double(point.getX() - dot, point.getY() - dot, 2 * dot, 2 * dot));
  }

  /** Marks a place or a way. */
  void mark(MarkTarget target) {
    Color accent = Palette.accent();
    graphics.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), 190));
    graphics.setStroke(new BasicStroke(em / 4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    if (target.from().isPresent()) {
      graphics.draw(new Line2D.Double(target.from().get(), target.at()));
      return;
    }
    double radius = 0.7 * em;
    graphics.draw(
        new Ellipse2D.Double(
            target.at().getX() - radius, target.at().getY() - radius, 2 * radius, 2 * radius));
  }

  /** Squares at which devices are held. */
  void handles(Collection<Point2D> places) {
    double side = 0.6 * em;
    graphics.setStroke(new BasicStroke(1.5f));
    for (Point2D at : places) {
      Rectangle2D square =
          new Rectangle2D.Double(at.getX() - side / 2, at.getY() - side / 2, side, side);
      graphics.setColor(Palette.card());
      graphics.fill(square);
      graphics.setColor(Palette.accent());
      graphics.draw(square);
    }
  }

  /** What is known of what the pointer is on, in lines. */
  void pointed(Optional<Point> pointer, Optional<String> words) {
    if (pointer.isPresent() && words.isPresent()) {
      double x = pointer.get().x + NEAR_POINTER_EM * em;
      double y = pointer.get().y + NEAR_POINTER_EM * em;
      int lines = (int) words.get().lines().count();
      double left = Math.clamp(x, 0, Math.max(0, width - chipWidth(words.get())));
      double top = Math.clamp(y, 0, Math.max(0, height - chipHeight(lines)));
      // Names that it lies on are not read through it.
      chip(words.get(), left, top, OPAQUE);
    }
  }

  private double chipWidth(String text) {
    return em + text.lines().mapToInt(metrics::stringWidth).max().orElse(0);
  }

  private double chipHeight(int lines) {
    return lines * metrics.getHeight() + em / 4.0;
  }

  /** A short text on a plate with this corner. */
  private void chip(String text, double left, double top) {
    chip(text, left, top, SEEN_THROUGH);
  }

  private void chip(String text, double left, double top, int alpha) {
    List<String> lines = text.lines().toList();
    plate(left, top, chipWidth(text), chipHeight(lines.size()), alpha);
    graphics.setColor(Palette.dark() ? Color.WHITE : Color.BLACK);
    double base = top + em / 8.0 + metrics.getAscent();
    for (String each : lines) {
      graphics.drawString(each, (float) (left + em / 2.0), (float) base);
      base += metrics.getHeight();
    }
  }

  private void plate(double x, double y, double wide, double high) {
    plate(x, y, wide, high, SEEN_THROUGH);
  }

  /**
   * @param alpha how little is seen of what is below, up to 255 for nothing
   */
  private void plate(double x, double y, double wide, double high, int alpha) {
    RoundRectangle2D plate = new RoundRectangle2D.Double(x, y, wide, high, em / 2.0, em / 2.0);
    Color card = Palette.card();
    graphics.setColor(new Color(card.getRed(), card.getGreen(), card.getBlue(), alpha));
    graphics.fill(plate);
    graphics.setColor(Palette.line());
    graphics.setStroke(new BasicStroke(1));
    graphics.draw(plate);
  }
}
