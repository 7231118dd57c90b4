/**
 * Reads JSON files that people write, and says with line and column what is wrong in one. Open
 * {@link org.pendant.controller.json.JsonFields} first, then {@link
 * org.pendant.controller.json.JsonFile}.
 */
package org.pendant.controller.json;
