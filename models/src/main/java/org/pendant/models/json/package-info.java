/**
 * JSON files, those that come with the program and those that people write: one reader, which says
 * with line and column what is wrong in one. Open {@link org.pendant.models.json.JsonFile} first,
 * then {@link org.pendant.models.json.JsonFields}.
 */
package org.pendant.models.json;
