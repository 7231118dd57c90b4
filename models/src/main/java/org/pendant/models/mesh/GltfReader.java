package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/**
 * glTF reader: reads the triangles of all meshes of the scene that a file shows, where its nodes
 * put them (Khronos: "glTF 2.0 Specification"). Its y, which is up, becomes z, and its z becomes
 * -y. Of materials the base colour is read; their pictures, animations, skins and what bends meshes
 * are passed over.
 */
final class GltfReader {
  private static final int MAX_NODES = 10_000;
  private static final int MAX_DEPTH = 100;
  private static final int MAX_MESHES = 10_000;
  private static final int MAX_PRIMITIVES = 10_000;
  private static final int MAX_MATERIALS = 10_000;

  /** Points of all primitives, also those that are the same ones again. */
  private static final int MAX_POINTS = 12 * TriangleMesh.MAX_TRIANGLES;

  private static final int MATRIX = 16;
  private static final int TRIANGLES = 4;
  private static final int STRIP = 5;
  private static final int FAN = 6;

  /** Extensions without which the shape of a thing can be read, by how they begin. */
  private static final List<String> HARMLESS =
      List.of("KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_xmp");

  private static final String ROUGHNESS = "pbrMetallicRoughness";
  private static final String FACTOR = "baseColorFactor";

  private static final Set<String> KNOWN = Set.of("KHR_mesh_quantization");

  private final MeshAssembly into;
  private final GltfBuffers buffers;
  private final List<JsonFields> nodes;
  private final List<JsonFields> meshes;
  private final List<JsonFields> materials;
  private final boolean[] met;
  private final double[][] frames = new double[MAX_DEPTH + 1][MATRIX];
  private int primitives;
  private long pointsRead;

  private GltfReader(GltfFile file, MeshNeighbours beside, MeshAssembly into)
      throws MeshException, JsonException {
    this.into = into;
    JsonFields root = file.root();
    requireVersion(root);
    requireExtensions(root);
    buffers = new GltfBuffers(file, beside);
    nodes = GltfBuffers.list(root, "nodes", MAX_NODES);
    meshes = GltfBuffers.list(root, "meshes", MAX_MESHES);
    materials = GltfBuffers.list(root, "materials", MAX_MATERIALS);
    met = new boolean[nodes.size()];
    for (int i = 0; i < MATRIX; i += 5) {
      frames[0][i] = 1;
    }
    for (int node : roots(root)) {
      visit(node, 1);
    }
  }

  /** Reads a file. */
  static void read(byte[] bytes, MeshNeighbours beside, MeshAssembly into) throws MeshException {
    try {
      var _ = new GltfReader(GltfFile.of(bytes), beside, into);
    } catch (JsonException e) {
      throw new MeshException(e.getMessage());
    }
  }

  private static void requireVersion(JsonFields root) throws JsonException {
    Json.Text version = root.object("asset").text("version");
    if (!version.value().startsWith("2.")) {
      throw version.place().refusal(text("version", version.described()));
    }
  }

  private static void requireExtensions(JsonFields root) throws JsonException {
    if (root.optional("extensionsRequired").isEmpty()) {
      return;
    }
    for (String extension : root.texts("extensionsRequired")) {
      if (!KNOWN.contains(extension) && HARMLESS.stream().noneMatch(extension::startsWith)) {
        throw root.required("extensionsRequired")
            .place()
            .refusal(
                text(
                    extension.contains("draco") || extension.contains("compression")
                        ? "compression"
                        : "extension",
                    Json.quoted(extension)));
      }
    }
  }

  /** The nodes of the scene that is shown; without any, those that are in no other one. */
  private List<Integer> roots(JsonFields root) throws JsonException {
    List<JsonFields> scenes = GltfBuffers.list(root, "scenes", MAX_NODES);
    if (!scenes.isEmpty()) {
      int shown = GltfBuffers.optionalIndex(root, "scene", scenes.size()).orElse(0);
      return children(scenes.get(shown), "nodes");
    }
    boolean[] within = new boolean[nodes.size()];
    for (JsonFields node : nodes) {
      for (int child : children(node, "children")) {
        within[child] = true;
      }
    }
    List<Integer> roots = new ArrayList<>();
    for (int i = 0; i < within.length; i++) {
      if (!within[i]) {
        roots.add(i);
      }
    }
    return roots;
  }

  private List<Integer> children(JsonFields of, String key) throws JsonException {
    List<Integer> children = new ArrayList<>();
    for (Json each : of.array(key, MAX_NODES)) {
      if (!(each instanceof Json.Numeral number)
          || number.value() != Math.rint(number.value())
          || number.value() < 0
          || number.value() >= nodes.size()) {
        throw each.place().refusal(text("wrongChild", key, each.described()));
      }
      children.add((int) number.value());
    }
    return children;
  }

  private void visit(int number, int depth) throws MeshException, JsonException {
    JsonFields node = nodes.get(number);
    if (met[number]) {
      throw node.place().refusal(text("nodeTwice", number));
    }
    met[number] = true;
    if (depth > MAX_DEPTH) {
      throw node.place().refusal(text("nodesTooDeep", MAX_DEPTH));
    }
    multiply(frames[depth - 1], GltfNode.matrix(node), frames[depth]);
    Optional<Integer> mesh = GltfBuffers.optionalIndex(node, "mesh", meshes.size());
    if (mesh.isPresent()) {
      addMesh(meshes.get(mesh.get()), frames[depth]);
    }
    for (int child : children(node, "children")) {
      visit(child, depth + 1);
    }
  }

  private static void multiply(double[] a, double[] b, double[] product) {
    for (int column = 0; column < 4; column++) {
      for (int row = 0; row < 4; row++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          sum += a[4 * k + row] * b[4 * column + k];
        }
        product[4 * column + row] = sum;
      }
    }
  }

  private void addMesh(JsonFields mesh, double[] frame) throws MeshException, JsonException {
    for (JsonFields primitive : GltfBuffers.list(mesh, "primitives", MAX_PRIMITIVES)) {
      if (++primitives > MAX_PRIMITIVES) {
        throw primitive.place().refusal(text("tooManyPrimitives", MAX_PRIMITIVES));
      }
      double mode = primitive.optional("mode").isPresent() ? primitive.number("mode") : TRIANGLES;
      if (mode == TRIANGLES || mode == STRIP || mode == FAN) {
        addPrimitive(primitive, (int) mode, frame);
      }
    }
  }

  private void addPrimitive(JsonFields primitive, int mode, double[] frame)
      throws MeshException, JsonException {
    JsonFields attributes = primitive.object("attributes");
    if (attributes.optional("POSITION").isEmpty()) {
      return;
    }
    GltfBuffers.Numbers points =
        buffers.points(GltfBuffers.index(attributes, "POSITION", buffers.accessors()));
    pointsRead += points.count();
    if (pointsRead > MAX_POINTS) {
      throw new MeshException(text("tooManyRepeatedPoints", MAX_POINTS));
    }
    int[] numbers = new int[points.count()];
    for (int i = 0; i < numbers.length; i++) {
      int number = i;
      double x = points.at(i, 0);
      double y = points.at(i, 1);
      double z = points.at(i, 2);
      numbers[i] =
          into.point(
              () -> text("point", number),
              frame[0] * x + frame[4] * y + frame[8] * z + frame[12],
              -(frame[2] * x + frame[6] * y + frame[10] * z + frame[14]),
              frame[1] * x + frame[5] * y + frame[9] * z + frame[13]);
    }
    Optional<Integer> accessor =
        GltfBuffers.optionalIndex(primitive, "indices", buffers.accessors());
    int[] corners = accessor.isPresent() ? corners(accessor.get(), numbers) : numbers;
    into.colour(colour(primitive));
    boolean mirrored = GltfNode.mirrors(frame);
    int step = mode == TRIANGLES ? 3 : 1;
    for (int i = 0; i + 2 < corners.length; i += step) {
      int a = corners[mode == FAN ? 0 : i];
      int b = corners[i + 1];
      int c = corners[i + 2];
      boolean turned = mirrored ^ (mode == STRIP && i % 2 == 1);
      into.triangle(a, turned ? c : b, turned ? b : c);
    }
  }

  /** The base colour of its material, where that has one; its picture is passed over. */
  private int colour(JsonFields primitive) throws JsonException {
    Optional<Integer> material = GltfBuffers.optionalIndex(primitive, "material", materials.size());
    if (material.isEmpty()) {
      return TriangleMesh.NO_COLOUR;
    }
    JsonFields of = materials.get(material.get());
    if (of.optional(ROUGHNESS).isEmpty() || of.object(ROUGHNESS).optional(FACTOR).isEmpty()) {
      return TriangleMesh.NO_COLOUR;
    }
    double[] linear = of.object(ROUGHNESS).vector(FACTOR, 4);
    int rgb = 0;
    for (int i = 0; i < 3; i++) {
      if (!(linear[i] >= 0 && linear[i] <= 1)) {
        throw of.object(ROUGHNESS)
            .required(FACTOR)
            .place()
            .refusal(text("colourOutside", FACTOR, linear[i]));
      }
      rgb = rgb << 8 | (int) Math.round(255 * onScreen(linear[i]));
    }
    return rgb;
  }

  /** The nonlinear value of a linear one (IEC 61966-2-1, sRGB). */
  private static double onScreen(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
  }

  private int[] corners(int accessor, int[] numbers) throws MeshException, JsonException {
    GltfBuffers.Numbers indices = buffers.indices(accessor);
    int[] corners = new int[indices.count()];
    for (int i = 0; i < corners.length; i++) {
      double index = indices.at(i, 0);
      if (index < 0 || index >= numbers.length || index != Math.rint(index)) {
        throw new MeshException(text("noSuchPoint", i, index, numbers.length));
      }
      corners[i] = numbers[(int) index];
    }
    return corners;
  }
}
