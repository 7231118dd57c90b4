/**
 * Reads the JSON files that come with the program, and says precisely what is wrong with one. Open
 * {@link org.pendant.models.json.JsonObject}, there is nothing else.
 */
package org.pendant.models.json;
