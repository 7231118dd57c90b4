package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** glTF buffers: the numbers of a file, by its accessors. Whatever they say stays in bounds. */
final class GltfBuffers {
  private static final int MAX_BUFFERS = 100;
  private static final int MAX_VIEWS = 100_000;
  private static final Range BYTES = new Range(0, MeshFile.MAX_BYTES, "");
  private static final Range STRIDE = new Range(4, 252, "");
  private static final Range COUNT = new Range(1, 3.0 * TriangleMesh.MAX_TRIANGLES, "");
  private static final Range COMPONENT = new Range(5120, 5126, "");

  private final List<ByteBuffer> buffers = new ArrayList<>();
  private final List<JsonFields> views;
  private final List<JsonFields> accessors;

  GltfBuffers(GltfFile file, MeshNeighbours beside) throws MeshException, JsonException {
    long all = 0;
    for (JsonFields buffer : list(file.root(), "buffers", MAX_BUFFERS)) {
      int length = whole(buffer, "byteLength", BYTES);
      ByteBuffer bytes = buffer(buffer, file, beside);
      if (bytes.remaining() < length) {
        throw new MeshException(text("bufferCut", buffers.size(), bytes.remaining(), length));
      }
      all += length;
      if (all > MeshFile.MAX_BYTES) {
        throw new MeshException(text("buffersTooLong", MeshFile.MAX_BYTES));
      }
      buffers.add(bytes.slice(0, length).order(ByteOrder.LITTLE_ENDIAN));
    }
    views = list(file.root(), "bufferViews", MAX_VIEWS);
    accessors = list(file.root(), "accessors", MAX_VIEWS);
  }

  /** Numbers of an accessor: some for each element. */
  interface Numbers {
    /** How many elements there are. */
    int count();

    /** A number of an element. */
    double at(int element, int component);
  }

  /** The objects of an array that may be left out. */
  static List<JsonFields> list(JsonFields in, String key, int most) throws JsonException {
    List<JsonFields> list = new ArrayList<>();
    for (Json each : in.array(key, most)) {
      list.add(new JsonFields(each, key));
    }
    return list;
  }

  /** A whole number that must be there. */
  static int whole(JsonFields in, String key, Range range) throws JsonException {
    double value = in.number(key, range);
    if (value != Math.rint(value)) {
      throw in.required(key).place().refusal(text("noWholeNumber", key, value));
    }
    return (int) value;
  }

  private static int offset(JsonFields in) throws JsonException {
    return in.optional("byteOffset").isPresent() ? whole(in, "byteOffset", BYTES) : 0;
  }

  /** The element of a list that a key names. */
  static JsonFields named(JsonFields in, String key, List<JsonFields> list) throws JsonException {
    return list.get(index(in, key, list.size()));
  }

  /** The number of an element of a list, which must be there. */
  static int index(JsonFields in, String key, int size) throws JsonException {
    if (size == 0) {
      throw in.required(key).place().refusal(text("namesNothing", key));
    }
    return whole(in, key, new Range(0, size - 1.0, ""));
  }

  private static ByteBuffer buffer(JsonFields buffer, GltfFile file, MeshNeighbours beside)
      throws MeshException, JsonException {
    if (buffer.optional("uri").isEmpty()) {
      return file.behind().orElseThrow(() -> new MeshException(text("bufferWithoutUri")));
    }
    Json.Text uri = buffer.text("uri");
    String text = uri.value();
    if (text.toLowerCase(Locale.ROOT).startsWith("data:")) {
      int comma = text.indexOf(',');
      if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
        throw uri.place().refusal(text("uriNotBase64Data", uri.described()));
      }
      try {
        return ByteBuffer.wrap(Base64.getDecoder().decode(text.substring(comma + 1)));
      } catch (IllegalArgumentException e) {
        throw uri.place().refusal(text("uriNoBase64", e.getMessage()));
      }
    }
    String name = decoded(uri);
    try {
      return ByteBuffer.wrap(beside.read(name));
    } catch (IOException e) {
      throw uri.place().refusal(name + ": " + e.getMessage());
    }
  }

  /** The name of a file beside this one, or below. */
  private static String decoded(Json.Text uri) throws JsonException {
    String name = withoutPercent(uri);
    if (name.startsWith("/")
        || name.indexOf('\\') >= 0
        || name.indexOf(':') >= 0
        || List.of(name.split("/", -1)).contains("..")) {
      throw uri.place().refusal(text("uriOutside", uri.described()));
    }
    return name;
  }

  /** Bytes that are written as % and two digits, as names with spaces have them. */
  private static String withoutPercent(Json.Text uri) throws JsonException {
    byte[] letters = uri.value().getBytes(StandardCharsets.UTF_8);
    ByteBuffer name = ByteBuffer.allocate(letters.length);
    for (int i = 0; i < letters.length; i++) {
      if (letters[i] != '%') {
        name.put(letters[i]);
        continue;
      }
      int high = i + 2 < letters.length ? Character.digit((char) letters[i + 1], 16) : -1;
      int low = i + 2 < letters.length ? Character.digit((char) letters[i + 2], 16) : -1;
      if (high < 0 || low < 0) {
        throw uri.place().refusal(text("uriPercent", uri.described()));
      }
      name.put((byte) (16 * high + low));
      i += 2;
    }
    return new String(name.array(), 0, name.position(), StandardCharsets.UTF_8);
  }

  /** Where three coordinates of points are. */
  Numbers points(int accessor) throws MeshException, JsonException {
    return numbers(accessor, "VEC3", 3);
  }

  /** Numbers of points. */
  Numbers indices(int accessor) throws MeshException, JsonException {
    return numbers(accessor, "SCALAR", 1);
  }

  int accessors() {
    return accessors.size();
  }

  private Numbers numbers(int number, String type, int each) throws MeshException, JsonException {
    JsonFields accessor = accessors.get(number);
    Json.Text is = accessor.text("type");
    if (!is.value().equals(type)) {
      throw is.place().refusal(text("wrongType", is.described(), type));
    }
    if (accessor.optional("sparse").isPresent() || accessor.optional("bufferView").isEmpty()) {
      throw accessor.place().refusal(text("sparse"));
    }
    int component = whole(accessor, "componentType", COMPONENT);
    int size = size(component, accessor);
    int count = whole(accessor, "count", COUNT);
    JsonFields view = named(accessor, "bufferView", views);
    ByteBuffer buffer = buffers.get(index(view, "buffer", buffers.size()));
    int viewAt = offset(view);
    int viewLength = whole(view, "byteLength", BYTES);
    int stride =
        view.optional("byteStride").isPresent() ? whole(view, "byteStride", STRIDE) : each * size;
    int at = offset(accessor);
    long needed = at + (long) stride * (count - 1) + (long) each * size;
    if (needed > viewLength || (long) viewAt + viewLength > buffer.limit()) {
      throw accessor
          .place()
          .refusal(
              text(
                  "accessorTooLong",
                  count,
                  needed,
                  Math.max(0, Math.min(viewLength, buffer.limit() - viewAt))));
    }
    boolean normalized = accessor.flag("normalized");
    int first = viewAt + at;
    return new Numbers() {
      @Override
      public int count() {
        return count;
      }

      @Override
      public double at(int element, int part) {
        return number(buffer, first + element * stride + part * size, component, normalized);
      }
    };
  }

  private static int size(int component, JsonFields accessor) throws JsonException {
    return switch (component) {
      case 5120, 5121 -> 1;
      case 5122, 5123 -> 2;
      case 5125, 5126 -> 4;
      default ->
          throw accessor
              .required("componentType")
              .place()
              .refusal(text("componentType", component));
    };
  }

  private static double number(ByteBuffer buffer, int at, int component, boolean normalized) {
    return switch (component) {
      case 5120 -> normalized ? Math.max(-1, buffer.get(at) / 127.0) : buffer.get(at);
      case 5121 -> Byte.toUnsignedInt(buffer.get(at)) / (normalized ? 255.0 : 1);
      case 5122 -> normalized ? Math.max(-1, buffer.getShort(at) / 32767.0) : buffer.getShort(at);
      case 5123 -> Short.toUnsignedInt(buffer.getShort(at)) / (normalized ? 65535.0 : 1);
      case 5125 -> Integer.toUnsignedLong(buffer.getInt(at));
      default -> buffer.getFloat(at);
    };
  }

  /** The index of an optional key, if it is there. */
  static Optional<Integer> optionalIndex(JsonFields in, String key, int size) throws JsonException {
    return in.optional(key).isPresent() ? Optional.of(index(in, key, size)) : Optional.empty();
  }
}
