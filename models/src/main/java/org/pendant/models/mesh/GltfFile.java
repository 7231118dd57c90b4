package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.io.ByteArrayInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * glTF file: the JSON of a file, and the bytes that a binary one has behind it (Khronos: "glTF 2.0
 * Specification", chapter 4).
 *
 * @param root what the file says
 * @param behind the binary part; empty where there is none
 */
record GltfFile(JsonFields root, Optional<ByteBuffer> behind) {
  /** What messages call the text of the file. */
  private static final String NAME = "JSON";

  /** Objects and arrays within one another at most: extensions go deep. */
  private static final int MAX_DEPTH = 32;

  private static final int MAGIC = 0x46546C67;
  private static final int HEADER = 12;
  private static final int CHUNK_HEADER = 8;
  private static final int JSON_CHUNK = 0x4E4F534A;
  private static final int BINARY_CHUNK = 0x004E4942;

  /** Takes a file apart. */
  static GltfFile of(byte[] bytes) throws MeshException, JsonException {
    ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    if (bytes.length < HEADER || file.getInt(0) != MAGIC) {
      return new GltfFile(root(bytes), Optional.empty());
    }
    int version = file.getInt(4);
    long length = Integer.toUnsignedLong(file.getInt(8));
    if (version != 2) {
      throw new MeshException(text("gltfVersion", Integer.toUnsignedString(version)));
    }
    if (length > bytes.length) {
      throw new MeshException(text("gltfCut", bytes.length, length));
    }
    ByteBuffer text = chunk(file, HEADER, JSON_CHUNK);
    int next = HEADER + CHUNK_HEADER + text.remaining();
    byte[] json = new byte[text.remaining()];
    text.get(json);
    return new GltfFile(
        root(json),
        next + CHUNK_HEADER <= bytes.length
            ? Optional.of(chunk(file, next, BINARY_CHUNK))
            : Optional.empty());
  }

  private static ByteBuffer chunk(ByteBuffer file, int at, int type) throws MeshException {
    if (at + CHUNK_HEADER > file.limit()) {
      throw new MeshException(text("gltfCutBeforeJson"));
    }
    long length = Integer.toUnsignedLong(file.getInt(at));
    if (length > file.limit() - at - CHUNK_HEADER) {
      throw new MeshException(text("gltfPartCut", file.limit() - at - CHUNK_HEADER, length));
    }
    if (file.getInt(at + 4) != type) {
      throw new MeshException(text("gltfParts"));
    }
    return file.slice(at + CHUNK_HEADER, (int) length).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static JsonFields root(byte[] json) throws JsonException {
    Json root = JsonFile.read(NAME, new ByteArrayInputStream(json), MeshFile.MAX_BYTES, MAX_DEPTH);
    return new JsonFields(root, "a glTF file");
  }
}
