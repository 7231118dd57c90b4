package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.check.Nearest;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Scene reader: reads one from JSON; docs/scene.md describes the file. */
public final class SceneReader {
  private final List<SceneObject> objects = new ArrayList<>();
  private final Map<String, FilePosition> places = new HashMap<>();

  private final MeshReader meshes;

  SceneReader(MeshFiles files) {
    meshes = new MeshReader(files);
  }

  /**
   * Reads a scene that names no meshes; see {@link #read(String, InputStream, MeshFiles)}.
   *
   * @throws JsonException for the first thing that is wrong
   */
  public static Scene read(String fileName, InputStream in) throws JsonException {
    return read(fileName, in, MeshFiles.NONE);
  }

  /**
   * Reads all of {@code in}, which the caller closes.
   *
   * @param fileName for messages
   * @param meshes the files that it may name
   * @throws JsonException for the first thing that is wrong, with its place; also if the file
   *     cannot be read or is too large
   */
  public static Scene read(String fileName, InputStream in, MeshFiles meshes) throws JsonException {
    return read(JsonFile.read(fileName, in), meshes);
  }

  /**
   * As the other, of a file that has been read.
   *
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static Scene read(Json file, MeshFiles meshes) throws JsonException {
    return new SceneReader(meshes).scene(file);
  }

  private Scene scene(Json root) throws JsonException {
    JsonFields fields = new JsonFields(root, text("aScene"));
    fields.allow(
        Nearest::among,
        "objects",
        "load",
        "tool",
        "push",
        "links",
        "devices",
        "rules",
        "arms",
        "script",
        "wires");
    for (Json each : fields.array("objects", Scene.MAX_OBJECTS)) {
      add(each);
    }
    SceneTool tool = ToolReader.read(fields, this);
    Optional<Json> load = fields.optional("load");
    Optional<Payload> payload =
        load.isPresent() ? Optional.of(LoadReader.load(load.get())) : Optional.empty();
    Wrench push = push(fields);
    LinkContact links = links(fields);
    try {
      return new Scene(objects, payload, tool.points(), tool.bodies(), push, links);
    } catch (IllegalArgumentException e) {
      // each part is right by itself: bodies overlap, or there are too many of them, or a load
      Json wrong = objects.isEmpty() ? load.orElse(root) : fields.required("objects");
      throw wrong.place().refusal(e.getMessage());
    }
  }

  private static LinkContact links(JsonFields scene) throws JsonException {
    if (scene.optional("links").isEmpty()) {
      return LinkContact.STOP;
    }
    Json.Text word = scene.text("links");
    Optional<LinkContact> contact = LinkContact.of(word.value());
    if (contact.isEmpty()) {
      throw word.place().refusal(text("linksWord", word.described()));
    }
    return contact.get();
  }

  private static Wrench push(JsonFields scene) throws JsonException {
    Optional<Json> value = scene.optional("push");
    if (value.isEmpty()) {
      return Wrench.ZERO;
    }
    JsonFields fields = new JsonFields(value.get(), text("aPush"));
    fields.allow(Nearest::among, "force", "torque");
    Vector3 force = vectorOrZero(fields, "force");
    Vector3 torque = vectorOrZero(fields, "torque");
    return new Wrench(force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z());
  }

  private static Vector3 vectorOrZero(JsonFields fields, String key) throws JsonException {
    return fields.optional(key).isPresent()
        ? Vector3.read(fields, key, ContactWorld.APPLIED)
        : new Vector3(0, 0, 0);
  }

  /** An object by its type. */
  SceneObject object(Json each, JsonFields fields) throws JsonException {
    Json.Text type = fields.text("type");
    return switch (type.value()) {
      case "plane" -> plane(new JsonFields(each, text("aPlane")));
      case "box" -> box(new JsonFields(each, text("aBox")));
      case "sphere" -> sphere(new JsonFields(each, text("aSphere")));
      case "cylinder", "capsule" ->
          rod(
              new JsonFields(
                  each, text(type.value().equals("capsule") ? "aCapsule" : "aCylinder")));
      case "mesh" -> mesh(each, new JsonFields(each, text("aMesh")));
      case "compound" -> compound(new JsonFields(each, text("aCompound")));
      default -> throw type.place().refusal(text("objectType", type.described()));
    };
  }

  private void add(Json each) throws JsonException {
    JsonFields fields = new JsonFields(each, text("sceneObject"));
    SceneObject object = object(each, fields);
    Json.Text name = fields.text("name");
    FilePosition first = places.putIfAbsent(object.name(), name.place());
    if (first != null) {
      throw name.place().refusal(text("nameTwice", name.described(), first.line()));
    }
    objects.add(object);
  }

  private static SceneObject plane(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "point", "normal", "material");
    String name = name(fields);
    Vector3 point = Vector3.read(fields, "point", SceneRange.POSITION);
    Vector3 normal = Vector3.read(fields, "normal", SceneObject.Plane.NORMAL);
    if (!SceneObject.Plane.NORMAL_LENGTH.holds(normal.length())) {
      throw fields
          .required("normal")
          .place()
          .refusal(SceneObject.Plane.NORMAL_LENGTH.refusal("length of normal", normal.length()));
    }
    return new SceneObject.Plane(name, point, normal, material(fields));
  }

  private static SceneObject box(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "pose", "size", "mass", "material");
    return new SceneObject.Box(
        name(fields),
        pose(fields),
        Vector3.read(fields, "size", SceneRange.SIZE),
        material(fields),
        mass(fields));
  }

  private static SceneObject rod(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "pose", "radius", "length", "mass", "material");
    return new SceneObject.Rod(
        name(fields),
        pose(fields),
        fields.number("radius", SceneRange.SIZE),
        fields.number("length", SceneRange.SIZE),
        fields.text("type").value().equals("capsule"),
        material(fields),
        mass(fields));
  }

  private SceneObject mesh(Json whole, JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "pose", "mesh", "unit", "mass", "material");
    String name = name(fields);
    Pose pose = pose(fields);
    MeshPart part = meshes.part(whole, fields);
    Material material = material(fields);
    double massKg = mass(fields);
    try {
      return new SceneObject.Mesh(name, pose, part, material, massKg);
    } catch (IllegalArgumentException e) {
      // all else is right by itself: what it is made of cannot have a mass
      throw fields
          .required("mass")
          .place()
          .refusal(text("standsWithoutMass", part.file(), e.getMessage()));
    }
  }

  private SceneObject compound(JsonFields fields) throws JsonException {
    return new CompoundReader(this).read(fields, name(fields), pose(fields), material(fields));
  }

  private static Pose pose(JsonFields fields) throws JsonException {
    List<Json> six = fields.numbers("pose", Pose.SIZE);
    double[] pose = new double[Pose.SIZE];
    for (int i = 0; i < pose.length; i++) {
      pose[i] = JsonFields.number("pose[" + i + "]", six.get(i), SceneObject.Box.poseRange(i));
    }
    return Pose.of(pose);
  }

  private static SceneObject sphere(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "centre", "radius", "mass", "material");
    return new SceneObject.Sphere(
        name(fields),
        Vector3.read(fields, "centre", SceneRange.POSITION),
        fields.number("radius", SceneRange.SIZE),
        material(fields),
        mass(fields));
  }

  private static double mass(JsonFields object) throws JsonException {
    return object.optional("mass").isPresent() ? object.number("mass", SceneRange.MASS) : 0;
  }

  private static String name(JsonFields fields) throws JsonException {
    Json.Text name = fields.text("name");
    Optional<String> refusal = ObjectName.refusal(name.value());
    if (refusal.isPresent()) {
      throw name.place().refusal(refusal.get());
    }
    return name.value();
  }

  private static Material material(JsonFields object) throws JsonException {
    Optional<Json> value = object.optional("material");
    if (value.isEmpty()) {
      return Material.DEFAULT;
    }
    JsonFields fields = new JsonFields(value.get(), text("aMaterial"));
    fields.allow(Nearest::among, "stiffness", "damping", "friction", "restitution");
    return new Material(
        fields.number("stiffness", Material.STIFFNESS, Material.DEFAULT.stiffnessNPerM()),
        fields.number("damping", Material.DAMPING, Material.DEFAULT.dampingSPerM()),
        fields.number("friction", Material.FRICTION, Material.DEFAULT.friction()),
        fields.number("restitution", Material.RESTITUTION, 0));
  }
}
