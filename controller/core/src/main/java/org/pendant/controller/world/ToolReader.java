package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/** Tool reader: reads what is on the flange: points that touch things, and bodies. */
public final class ToolReader {
  private final SceneReader objects;

  private ToolReader(SceneReader objects) {
    this.objects = objects;
  }

  /**
   * The tool of an arm that has its own in a cell.
   *
   * @param meshes the files that it may name
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static SceneTool read(JsonFields fields, MeshFiles meshes) throws JsonException {
    return read(fields, new SceneReader(meshes));
  }

  static SceneTool read(JsonFields fields, SceneReader objects) throws JsonException {
    ToolReader reader = new ToolReader(objects);
    List<ToolPoint> points = new ArrayList<>();
    List<SceneObject> bodies = new ArrayList<>();
    for (Json each : fields.array("tool", Scene.MAX_TOOL_POINTS + Scene.MAX_TOOL_BODIES)) {
      JsonFields part = new JsonFields(each, text("toolPart"));
      if (part.optional("type").isPresent()) {
        bodies.add(reader.body(each, part, bodies));
        requireCount(each, "moreBodies", bodies.size(), Scene.MAX_TOOL_BODIES);
      } else {
        points.add(point(new JsonFields(each, text("toolPoint"))));
        requireCount(each, "morePoints", points.size(), Scene.MAX_TOOL_POINTS);
      }
    }
    return new SceneTool(points, bodies);
  }

  private static void requireCount(Json each, String refusalKey, int count, int most)
      throws JsonException {
    if (count > most) {
      throw each.place().refusal(text(refusalKey, most));
    }
  }

  private SceneObject body(Json each, JsonFields fields, List<SceneObject> before)
      throws JsonException {
    SceneObject body = objects.object(each, fields);
    if (body instanceof SceneObject.Plane || body instanceof SceneObject.Compound) {
      Json.Text type = fields.text("type");
      throw type.place().refusal(text("toolBodyType", type.described()));
    }
    if (before.stream().anyMatch(other -> other.name().equals(body.name()))) {
      Json.Text name = fields.text("name");
      throw name.place().refusal(text("bodyTwice", name.described()));
    }
    try {
      var _ = new ToolBody(body);
    } catch (IllegalArgumentException e) {
      throw each.place().refusal(body.name() + ": " + e.getMessage());
    }
    return body;
  }

  private static ToolPoint point(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "point", "radius");
    return new ToolPoint(
        Vector3.read(fields, "point", ToolPoint.POINT),
        fields.number("radius", ToolPoint.RADIUS, 0));
  }
}
