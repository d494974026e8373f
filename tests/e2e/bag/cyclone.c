// Another DDS, Cyclone DDS, reads each message of a bag by types made from the bag's own definitions, writes
// it again, and must come to the same bytes. Arguments: .db3 files. bag_types.h is written by the test: the
// table of the types.
#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bag_types.h"

static void fail(const char* why, const char* topic, long message) {
  fprintf(stderr, "cyclone: %s, message %ld: %s\n", topic, message, why);
  exit(1);
}

/// Cyclone DDS gives a type only with a sample of it that was written.
static const struct ddsi_sertype* learn(dds_entity_t participant, const dds_topic_descriptor_t* descriptor) {
  const dds_entity_t topic =
      dds_create_topic(participant, descriptor, strrchr(descriptor->m_typename, ':') + 1, NULL, NULL);
  const dds_entity_t reader = dds_create_reader(participant, topic, NULL, NULL);
  const dds_entity_t writer = dds_create_writer(participant, topic, NULL, NULL);
  void* empty = calloc(1, descriptor->m_size);
  struct ddsi_serdata* written = NULL;
  dds_sample_info_t info;
  if (topic < 0 || reader < 0 || writer < 0) return NULL;
  for (int i = 0; i < 1000 && !written; ++i) {
    if (dds_write(writer, empty) != DDS_RETCODE_OK ||
        dds_takecdr(reader, &written, 1, &info, DDS_ANY_STATE) < 0)
      break;
    if (!written) dds_sleepfor(DDS_MSECS(10));
  }
  free(empty);
  return written ? written->type : NULL;  // and the sample stays, with its type
}

static const struct ddsi_sertype* typeOf(dds_entity_t participant, const char* name) {
  for (size_t i = 0; i < sizeof bagTypes / sizeof *bagTypes; ++i) {
    if (strcmp(bagTypes[i].name, name) != 0) continue;
    if (!bagTypes[i].type) bagTypes[i].type = learn(participant, bagTypes[i].descriptor);
    if (!bagTypes[i].type) fail("no type", name, 0);
    return bagTypes[i].type;
  }
  fail("no definition", name, 0);
  return NULL;
}

static void check(const struct ddsi_sertype* type, const char* topic, long number, const void* data,
                  size_t size) {
  // What arrives over a network is filled up to a multiple of four; the header says by how much.
  const size_t padded = (size + 3) / 4 * 4;
  unsigned char* message = calloc(1, padded);
  memcpy(message, data, size);
  message[3] = (unsigned char)(padded - size);
  const ddsrt_iovec_t piece = {message, padded};
  struct ddsi_serdata* read = ddsi_serdata_from_ser_iov(type, SDK_DATA, 1, &piece, padded);
  if (!read) fail("is refused", topic, number);
  void* sample = ddsi_sertype_alloc_sample(type);
  if (!ddsi_serdata_to_sample(read, sample, NULL, NULL)) fail("cannot be read", topic, number);
  struct ddsi_serdata* written = ddsi_serdata_from_sample(type, SDK_DATA, sample);
  if (!written) fail("cannot be written", topic, number);
  const size_t length = ddsi_serdata_size(written);
  unsigned char* again = malloc(length);
  ddsi_serdata_to_ser(written, 0, length, again);
  if (length != padded || memcmp(again + 4, message + 4, size - 4) != 0)
    fail("is other bytes", topic, number);
  free(again);
  free(message);
  ddsi_serdata_unref(written);
  ddsi_sertype_free_sample(type, sample, DDS_FREE_ALL);
  ddsi_serdata_unref(read);
}

int main(int argc, char** argv) {
  const dds_entity_t participant = dds_create_participant(DDS_DOMAIN_DEFAULT, NULL, NULL);
  if (participant < 0) fail("no participant", "", 0);
  long count = 0;
  for (int i = 1; i < argc; ++i) {
    sqlite3* database = NULL;
    sqlite3_stmt* rows = NULL;
    if (sqlite3_open_v2(argv[i], &database, SQLITE_OPEN_READONLY, NULL) != SQLITE_OK ||
        sqlite3_prepare_v2(database,
                           "SELECT topics.type, topics.name, messages.data FROM messages JOIN topics ON "
                           "messages.topic_id = topics.id ORDER BY messages.id",
                           -1, &rows, NULL) != SQLITE_OK)
      fail("cannot be opened", argv[i], 0);
    while (sqlite3_step(rows) == SQLITE_ROW) {
      const struct ddsi_sertype* type = typeOf(participant, (const char*)sqlite3_column_text(rows, 0));
      check(type, (const char*)sqlite3_column_text(rows, 1), ++count, sqlite3_column_blob(rows, 2),
            (size_t)sqlite3_column_bytes(rows, 2));
    }
    sqlite3_finalize(rows);
    sqlite3_close(database);
  }
  dds_delete(participant);
  printf("%ld messages\n", count);
  return 0;
}
