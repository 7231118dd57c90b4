package org.pendant.sweep.table;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPOutputStream;

/**
 * Table in Apache Parquet's format, version 1 (https://github.com/apache/parquet-format): a column
 * that may have gaps for each of the table, with plain values in one page of each group of rows,
 * packed by gzip. Memory is that of one group of rows.
 *
 * <p>Parquet's own library needs Hadoop; what bundles it without is 20 MB in 14 jars, two of them
 * native, for all those who never sweep. Flat tables of three types need none of that.
 */
public final class ParquetTable {
  private static final byte[] MAGIC = "PAR1".getBytes(StandardCharsets.US_ASCII);
  private static final int GROUP_ROWS = 20_000;
  private static final int TYPE_INT64 = 2;
  private static final int TYPE_DOUBLE = 5;
  private static final int TYPE_BYTES = 6;
  private static final int OPTIONAL = 1;
  private static final int CONVERTED_UTF8 = 0;
  private static final int CODEC_GZIP = 2;
  private static final int PLAIN = 0;
  private static final int RLE = 3;

  private final OutputStream out;
  private final List<ResultColumn> columns;
  private final List<PageColumn> pages = new ArrayList<>();
  private final List<RowGroup> groups = new ArrayList<>();
  private long written;
  private int groupRows;
  private long rows;

  /** A chunk of one column, where it is in the file. */
  private record Chunk(long offset, int packedBytes, int bytes, int values) {}

  private record RowGroup(List<Chunk> chunks, int rows) {}

  /** The values of one column in the group of rows that is being made. */
  private static final class PageColumn {
    private final CellType type;
    private final ByteArrayOutputStream values = new ByteArrayOutputStream();
    private final ByteArrayOutputStream present = new ByteArrayOutputStream();
    private final ByteBuffer number =
        ByteBuffer.allocate(Long.BYTES).order(ByteOrder.LITTLE_ENDIAN);

    private PageColumn(CellType type) {
      this.type = type;
    }

    private void add(String cell) {
      boolean there = type == CellType.TEXT || !cell.isEmpty();
      present.write(there ? 1 : 0);
      if (!there) {
        return;
      }
      switch (type) {
        case WHOLE -> write(Long.parseLong(cell));
        case NUMBER -> write(Double.doubleToRawLongBits(Double.parseDouble(cell)));
        case TEXT -> {
          byte[] text = cell.getBytes(StandardCharsets.UTF_8);
          number.putInt(0, text.length);
          values.write(number.array(), 0, Integer.BYTES);
          values.writeBytes(text);
        }
      }
    }

    private void write(long bits) {
      number.putLong(0, bits);
      values.write(number.array(), 0, Long.BYTES);
    }

    /** Levels, which tell what is there, as runs; then the values. */
    private byte[] page() {
      byte[] levels = present.toByteArray();
      ByteArrayOutputStream runs = new ByteArrayOutputStream();
      int at = 0;
      while (at < levels.length) {
        int end = at + 1;
        while (end < levels.length && levels[end] == levels[at]) {
          end++;
        }
        for (int rest = (end - at) << 1; ; rest >>>= 7) {
          if ((rest & ~0x7F) == 0) {
            runs.write(rest);
            break;
          }
          runs.write((rest & 0x7F) | 0x80);
        }
        runs.write(levels[at]);
        at = end;
      }
      ByteArrayOutputStream page = new ByteArrayOutputStream();
      number.putInt(0, runs.size());
      page.write(number.array(), 0, Integer.BYTES);
      page.writeBytes(runs.toByteArray());
      page.writeBytes(values.toByteArray());
      values.reset();
      present.reset();
      return page.toByteArray();
    }
  }

  /**
   * Begins a table.
   *
   * @param out stays open
   */
  public ParquetTable(OutputStream out, List<ResultColumn> columns) throws IOException {
    this.out = out;
    this.columns = List.copyOf(columns);
    columns.forEach(each -> pages.add(new PageColumn(each.type())));
    write(MAGIC);
  }

  private void write(byte[] bytes) throws IOException {
    out.write(bytes);
    written += bytes.length;
  }

  /**
   * Adds a row.
   *
   * @param cells as {@link CsvRows} writes them: empty where there is no number
   * @throws NumberFormatException if one is no number in a column of numbers
   */
  public void add(List<String> cells) throws IOException {
    for (int i = 0; i < pages.size(); i++) {
      pages.get(i).add(cells.get(i));
    }
    groupRows++;
    rows++;
    if (groupRows == GROUP_ROWS) {
      endGroup();
    }
  }

  private void endGroup() throws IOException {
    List<Chunk> chunks = new ArrayList<>();
    for (PageColumn each : pages) {
      byte[] page = each.page();
      ByteArrayOutputStream packed = new ByteArrayOutputStream();
      try (GZIPOutputStream zip = new GZIPOutputStream(packed)) {
        zip.write(page);
      }
      byte[] header =
          new CompactThrift()
              .i32(1, 0)
              .i32(2, page.length)
              .i32(3, packed.size())
              .begin(5)
              .i32(1, groupRows)
              .i32(2, PLAIN)
              .i32(3, RLE)
              .i32(4, RLE)
              .end()
              .toBytes();
      chunks.add(
          new Chunk(
              written, header.length + packed.size(), header.length + page.length, groupRows));
      write(header);
      write(packed.toByteArray());
    }
    groups.add(new RowGroup(chunks, groupRows));
    groupRows = 0;
  }

  /** Ends the table; nothing more can be added. */
  public void end() throws IOException {
    if (groupRows > 0) {
      endGroup();
    }
    byte[] footer = footer();
    write(footer);
    write(
        ByteBuffer.allocate(Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(footer.length)
            .array());
    write(MAGIC);
  }

  private byte[] footer() {
    CompactThrift footer = new CompactThrift().i32(1, 1).structs(2, columns.size() + 1);
    footer.element().text(4, "results").i32(5, columns.size()).end();
    for (ResultColumn each : columns) {
      footer.element().i32(1, type(each)).i32(3, OPTIONAL).text(4, each.name());
      if (each.type() == CellType.TEXT) {
        footer.i32(6, CONVERTED_UTF8);
      }
      footer.end();
    }
    footer.i64(3, rows).structs(4, groups.size());
    for (RowGroup group : groups) {
      footer.element().structs(1, columns.size());
      long bytes = 0;
      for (int i = 0; i < columns.size(); i++) {
        Chunk chunk = group.chunks().get(i);
        bytes += chunk.bytes();
        footer
            .element()
            .i64(2, chunk.offset())
            .begin(3)
            .i32(1, type(columns.get(i)))
            .integers(2, PLAIN, RLE)
            .texts(3, columns.get(i).name())
            .i32(4, CODEC_GZIP)
            .i64(5, chunk.values())
            .i64(6, chunk.bytes())
            .i64(7, chunk.packedBytes())
            .i64(9, chunk.offset())
            .end()
            .end();
      }
      footer.i64(2, bytes).i64(3, group.rows()).end();
    }
    List<ResultColumn> described =
        columns.stream().filter(each -> !each.description().isEmpty()).toList();
    footer.structs(5, described.size());
    for (ResultColumn each : described) {
      String unit = each.unit().isEmpty() ? "" : ", " + each.unit();
      footer.element().text(1, each.name()).text(2, each.description() + unit).end();
    }
    return footer.text(6, "pendant").toBytes();
  }

  private static int type(ResultColumn column) {
    return switch (column.type()) {
      case WHOLE -> TYPE_INT64;
      case NUMBER -> TYPE_DOUBLE;
      case TEXT -> TYPE_BYTES;
    };
  }
}
