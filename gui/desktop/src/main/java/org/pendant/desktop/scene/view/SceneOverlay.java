package org.pendant.desktop.scene.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Point2D;
import java.awt.geom.RoundRectangle2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SpeedColours;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.kit.theme.Palette;
import org.pendant.models.pose.Pose;

/**
 * Scene overlay: what is written on the picture: the scale of speeds, names of frames, what the
 * pointer is on.
 */
final class SceneOverlay {
  private static final List<String> JOINT_FRAMES =
      List.of("J1", "J2", "J3", "J4", "J5", "J6, flange");

  /** With more of them names would cover the picture. */
  private static final int MAX_PLACE_NAMES = 15;

  private static final int MIN_WIDTH_FOR_LEGEND = 150;
  private static final double NEAR_POINTER_EM = 1.2;

  private final Graphics2D graphics;
  private final int width;
  private final int height;
  private final FontMetrics metrics;
  private final int em;

  /**
   * @param graphics at the scale of the component, with its font
   */
  SceneOverlay(Graphics2D graphics, int width, int height) {
    this.graphics = graphics;
    this.width = width;
    this.height = height;
    metrics = graphics.getFontMetrics();
    em = graphics.getFont().getSize();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
  }

  /** The colours of the trace and what they mean; nothing while there is no trace. */
  void legend(SceneModel model) {
    if (model.trace().size() < 2 || width < MIN_WIDTH_FOR_LEGEND) {
      return;
    }
    int bar = Math.min(11 * em, width - 5 * em);
    int thick = Math.max(4, em / 2);
    int left = em;
    int bottom = height - em;
    double mostMmPerS = 1000 * model.trace().scaleMPerS();
    String most = number(mostMmPerS) + " mm/s";
    int wide = bar - em / 2 + metrics.stringWidth(most) / 2;
    int high = thick + metrics.getHeight() + em / 2;
    plate(left - em / 2.0, bottom - high, wide + em, high + em / 2.0);
    int top = bottom - thick - metrics.getHeight();
    for (int x = 0; x < bar; x++) {
      double place = (x + 0.5) / bar;
      graphics.setColor(new Color(SpeedColours.rgb(place * place)));
      graphics.fillRect(left + x, top, 1, thick);
    }
    int base = bottom - metrics.getDescent();
    graphics.setColor(Palette.quiet());
    graphics.drawString("0", left, base);
    centred(number(mostMmPerS / 4), left + bar * SpeedColours.place(0.25), base);
    centred(most, left + bar - em / 2.0, base);
  }

  private static String number(double mmPerS) {
    return mmPerS < 10 && mmPerS != Math.rint(mmPerS)
        ? String.valueOf(Math.round(10 * mmPerS) / 10.0)
        : String.valueOf(Math.round(mmPerS));
  }

  private void centred(String text, double x, int base) {
    graphics.drawString(text, (float) (x - metrics.stringWidth(text) / 2.0), base);
  }

  /** Names beside the frames of the joints, where they are drawn. */
  void frameNames(PictureRequest shown) {
    Map<Point2D, String> names = new LinkedHashMap<>();
    List<Pose> frames = shown.model().framesInBase();
    for (int i = 0; i < frames.size() && i < JOINT_FRAMES.size(); i++) {
      Pose frame = frames.get(i);
      String name = JOINT_FRAMES.get(i);
      shown
          .camera()
          .pixel(new Vector3(frame.x(), frame.y(), frame.z()), width, height)
          .ifPresent(at -> addName(names, at, name));
    }
    names.forEach((at, name) -> chip(name, at.getX() + em / 2.0, at.getY() - em));
  }

  /** Names beside the places that a program goes to; that of a chosen one comes last, on top. */
  void placeNames(PictureRequest shown) {
    List<WaypointMarkers.Mark> marks = shown.model().waypointMarkers().marks();
    if (marks.size() > MAX_PLACE_NAMES) {
      marks = marks.stream().filter(WaypointMarkers.Mark::chosen).toList();
    }
    Map<Point2D, String> names = new LinkedHashMap<>();
    for (boolean chosen : new boolean[] {false, true}) {
      for (WaypointMarkers.Mark mark : marks) {
        Pose place = mark.inBase();
        if (mark.chosen() == chosen) {
          shown
              .camera()
              .pixel(new Vector3(place.x(), place.y(), place.z()), width, height)
              .ifPresent(at -> addName(names, at, mark.name()));
        }
      }
    }
    names.forEach((at, name) -> chip(name, at.getX() + em / 2.0, at.getY() + 1.5 * em));
  }

  /** Frames in one place share a plate. */
  private void addName(Map<Point2D, String> names, Point2D at, String name) {
    for (Map.Entry<Point2D, String> other : names.entrySet()) {
      if (other.getKey().distance(at) < em) {
        other.setValue(other.getValue() + ", " + name);
        return;
      }
    }
    names.put(at, name);
  }

  /** The name of what the pointer is on. */
  void pointed(Optional<Point> pointer, Optional<String> name) {
    if (pointer.isPresent() && name.isPresent()) {
      double x = pointer.get().x + NEAR_POINTER_EM * em;
      double y = pointer.get().y + 2 * NEAR_POINTER_EM * em;
      chip(name.get(), x, y);
    }
  }

  /** A short text on a plate, kept inside of the picture; {@code y} is its base line. */
  private void chip(String text, double x, double y) {
    double wide = metrics.stringWidth(text) + em;
    double high = metrics.getHeight() + em / 4.0;
    double left = Math.clamp(x, 0, Math.max(0, width - wide));
    double top = Math.clamp(y - metrics.getAscent() - em / 8.0, 0, Math.max(0, height - high));
    plate(left, top, wide, high);
    graphics.setColor(Palette.dark() ? Color.WHITE : Color.BLACK);
    graphics.drawString(
        text, (float) (left + em / 2.0), (float) (top + em / 8.0 + metrics.getAscent()));
  }

  private void plate(double x, double y, double wide, double high) {
    RoundRectangle2D plate = new RoundRectangle2D.Double(x, y, wide, high, em / 2.0, em / 2.0);
    Color card = Palette.card();
    graphics.setColor(new Color(card.getRed(), card.getGreen(), card.getBlue(), 215));
    graphics.fill(plate);
    graphics.setColor(Palette.line());
    graphics.setStroke(new BasicStroke(1));
    graphics.draw(plate);
  }
}
