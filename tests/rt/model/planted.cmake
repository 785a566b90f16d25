# These bugs are planted in the real sources, and the exploration must find each. A change of a line that is named here
# has to be made here too: a text that is not found is an error.

# suture_planted(name PART p TEXT t REPLACEMENT r SCENARIO s FINDS regex)
function(suture_planted name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PART;TEXT;REPLACEMENT;SCENARIO;FINDS" "")
  set(source ${rt}/${arg_PART}.cpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  string(FIND "${text}" "${arg_TEXT}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "The planted bug ${name}: ${source} has no\n  ${arg_TEXT}\n"
      "Say in tests/rt/model/planted.cmake what it has now.")
  endif()
  string(REPLACE "${arg_TEXT}" "${arg_REPLACEMENT}" text "${text}")
  file(CONFIGURE OUTPUT planted/${name}.cpp CONTENT "${text}" @ONLY)
  suture_explored(planted_${name} ${CMAKE_CURRENT_BINARY_DIR}/planted/${name}.cpp)
  target_compile_options(planted_${name} PRIVATE -w)
  suture_model_test(model_${name}_test ${arg_PART} planted_${name})
  suture_tier(fast model_${name}_test)
  add_test(NAME model.finds.${name} COMMAND model_${name}_test --gtest_filter=*/${arg_SCENARIO})
  set_tests_properties(model.finds.${name} PROPERTIES PASS_REGULAR_EXPRESSION "Which is: \"${arg_FINDS}")
endfunction()

suture_planted(ring_overrun PART queue/spsc_ring SCENARIO SpscRing FINDS "a r"
  TEXT "if (newTail - knownHead_ > mask_ + 1) return nullptr;"
  REPLACEMENT "if (newTail - knownHead_ > mask_ + 49) return nullptr;")
suture_planted(ring_unordered_read PART queue/spsc_ring SCENARIO SpscRing FINDS "a race on plain memory: written unordered"
  TEXT "knownTail_ = shared_->tail.load(std::memory_order_acquire)" REPLACEMENT "knownTail_ = shared_->tail.load(std::memory_order_relaxed)")
suture_planted(ring_unordered_reuse PART queue/spsc_ring SCENARIO SpscRing FINDS "a race on plain memory: overwritten"
  TEXT "knownHead_ = shared_->head.load(std::memory_order_acquire)" REPLACEMENT "knownHead_ = shared_->head.load(std::memory_order_relaxed)")
suture_planted(cells_unordered_reuse PART queue/mpsc_ring SCENARIO MpscRing FINDS "a race on plain memory"
  TEXT "head_ + mask_ + 1, std::memory_order_release" REPLACEMENT "head_ + mask_ + 1, std::memory_order_relaxed")
suture_planted(cells_unordered_reuse_of_one PART queue/mpsc_ring SCENARIO EventQueueOfOne FINDS "a race on plain memory"
  TEXT "head_ + mask_ + 1, std::memory_order_release" REPLACEMENT "head_ + mask_ + 1, std::memory_order_relaxed")
suture_planted(cells_early_front PART queue/mpsc_ring SCENARIO MpscRing FINDS "a "
  TEXT "sequenceAt(head_).load(std::memory_order_acquire) == head_ + 1"
  REPLACEMENT "sequenceAt(head_).load(std::memory_order_acquire) <= head_ + 1")
suture_planted(latest_shared_buffer PART queue/latest_cell SCENARIO LatestCell FINDS "a "
  TEXT "shared_->exchange(reading_, std::memory_order_acq_rel)"
  REPLACEMENT "shared_->exchange(shared_->load() & ~kFresh)")
suture_planted(latest_unordered PART queue/latest_cell SCENARIO LatestCell FINDS "a race on plain memory: written unordered"
  TEXT "shared_->exchange(writing_ | kFresh, std::memory_order_acq_rel)"
  REPLACEMENT "shared_->exchange(writing_ | kFresh, std::memory_order_acquire)")
suture_planted(mailbox_cut_after_cells PART queue/mailbox SCENARIO MailboxOrder FINDS "a command "
  TEXT "    if (std::exchange(cell->held, true)) increment(counters.overtaken);
  }"
  REPLACEMENT "    if (std::exchange(cell->held, true)) increment(counters.overtaken);
  }
  cut_ = published_->load(std::memory_order_acquire);")
suture_planted(mailbox_no_cut PART queue/mailbox SCENARIO MailboxOrder FINDS "a command "
  TEXT "next_->sequence > cut_" REPLACEMENT "false")
suture_planted(mailbox_forgotten_cell PART queue/mailbox SCENARIO MailboxOrder FINDS "the last command is lost"
  TEXT "    if (!cell->values.take(copier())) continue;"
  REPLACEMENT "    if (!cell->values.take(copier())) { cell->held = false; continue; }")
suture_planted(mailbox_not_counted PART queue/mailbox SCENARIO MailboxOrder FINDS "a command is not accounted for"
  TEXT "if (std::exchange(cell->held, true)) increment(counters.overtaken);" REPLACEMENT "cell->held = true;")
suture_planted(mailbox_one_too_many PART queue/mailbox SCENARIO MailboxCredits FINDS "more wait than the depth allows"
  TEXT "memory = waiting < limits.depth" REPLACEMENT "memory = waiting <= limits.depth")
suture_planted(mailbox_looks_for_room_once PART queue/mailbox SCENARIO MailboxRoom FINDS "it waits, there is room"
  TEXT "  roomAwaited_->raiseBehindTake();
  return left();" REPLACEMENT "  roomAwaited_->raiseBehindTake();
  return 0;")
suture_planted(row_not_checked_again PART state/state_table SCENARIO StateRow FINDS "a row is torn"
  TEXT "return header.sequence.load(std::memory_order_relaxed) == sequence;" REPLACEMENT "return true;")
suture_planted(row_not_marked PART state/state_table SCENARIO StateRow FINDS "a row is torn"
  TEXT "header.sequence.store(0, std::memory_order_relaxed);" REPLACEMENT "")
suture_planted(row_words_unordered PART state/state_table SCENARIO StateRow FINDS "a row is torn"
  TEXT "to[i].store(word, std::memory_order_release);" REPLACEMENT "to[i].store(word, std::memory_order_relaxed);")
suture_planted(row_read_unordered PART state/state_table SCENARIO StateRow FINDS "a row is torn"
  TEXT "from[i].load(std::memory_order_acquire);" REPLACEMENT "from[i].load(std::memory_order_relaxed);")
suture_planted(events_two_writers PART queue/event_queue SCENARIO EventQueue FINDS "a race on plain memory"
  TEXT "if (!alone && cell.writing.test_and_set(std::memory_order_acquire)) return false;" REPLACEMENT "")
suture_planted(events_two_alone PART queue/event_ring SCENARIO EventQueueOfTwo FINDS "a "
  TEXT "producers_ == Producers::One ? ring.claimAlone() : ring.claim()" REPLACEMENT "ring.claimAlone()")
suture_planted(events_large_lost PART queue/event_ring SCENARIO EventQueueLarge FINDS "an event was dropped"
  TEXT "cells->release(reinterpret_cast<const Reference*>(memory)->place);" REPLACEMENT "")
suture_planted(events_large_early PART queue/event_ring SCENARIO EventQueueLargeOfOne FINDS "a race on plain memory"
  TEXT "    memory = cells->at(" REPLACEMENT "    cells->release(reference.place);
    memory = cells->at(")
suture_planted(cells_unordered_release PART queue/mpsc_ring SCENARIO EventQueueLargeOfOne FINDS "a race on plain memory"
  TEXT "sequence.load(std::memory_order_relaxed) + mask_ + 1, std::memory_order_release"
  REPLACEMENT "sequence.load(std::memory_order_relaxed) + mask_ + 1, std::memory_order_relaxed")
suture_planted(bell_lost_ring PART doorbell SCENARIO Doorbell FINDS "it sleeps, there is work"
  TEXT "if (word_.compare_exchange_strong(expected, kAsleep, std::memory_order_seq_cst)) return true;"
  REPLACEMENT "word_.store(kAsleep); return true;")
suture_planted(bell_forgets_work PART doorbell SCENARIO DoorbellForTwo FINDS "what it was rung for is forgotten"
  TEXT "word_.fetch_or(bit, std::memory_order_seq_cst)" REPLACEMENT "word_.exchange(bit, std::memory_order_seq_cst)")
